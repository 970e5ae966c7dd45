// The picture of a scene in a window, and how the pointer and keys move its viewpoint.
//
// An ordinary widget that paints the renderer's image: no window system's OpenGL is needed, and
// tests without a display see the same pixels. Pictures come from a thread
// (painting/window_picture.h); a scene that takes long to draw holds nothing up. Unshifted buttons
// move the view (framing/camera.h), `c` puts the centre of rotation under the pointer
// (dissertation 4.1.7). Until the user moves it, the view frames the whole motion by itself.
#pragma once

#include "framing/extent.h"
#include "gestures/picking.h"
#include "labels/centroids.h"
#include "labels/fault_signs.h"
#include "labels/meters.h"
#include "painting/window_picture.h"
#include "picture/creating.h"
#include "picture/element_menu.h"
#include "picture/gizmo.h"
#include "picture/picture_editing.h"
#include "picture/pointing.h"
#include "picture/selecting.h"
#include "picture/throwing.h"
#include "workbench/scene_document.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace views {

class SceneDisplay : public QWidget, public SeenPicture {
    Q_OBJECT
public:
    // Shows the document's scene.
    SceneDisplay(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                 QWidget* parent = nullptr);

    void setTime(double time, bool moving);
    [[nodiscard]] double time() const { return time_; }

    void setDisplay(const render::Display& display); // but for what is hidden and opened
    // Bodies that this picture does not show; the scene is as it was.
    void setHidden(std::set<std::string> names);
    [[nodiscard]] const std::set<std::string>& hidden() const;
    void hide(const std::vector<editing::Element>& elements); // the bodies of them
    [[nodiscard]] const render::Display& display() const { return display_; }
    // The crowd of handles by its largest: those that were folded stand around it; none: of none.
    void openCrowd(const std::optional<render::HandleName>& largest);

    [[nodiscard]] const render::Camera& camera() const { return control_.camera(); }
    void setCamera(const render::Camera& camera); // the user's own from now on
    [[nodiscard]] bool framesItself() const {
        return seen_.framesItself;
    } // nobody has moved it yet
    void setOrthographic(bool orthographic);
    void frameAll();    // from the direction that is seen
    void frameOpened(); // from the best side, as if for the first time
    // Frames what stands there at this time, the selected bodies (none: all), or the whole motion;
    // fixed bodies included, from the direction that is seen.
    void frameNow();
    void frameSelected();
    void frameMotion();
    // The picture steps back until it shows all of these bodies; from far out of it, it frames what
    // stands there now. The view is the reader's own then.
    void bringIn(const std::vector<editing::Element>& elements);
    // The same for bodies that were made just now. A view of the scene stays as it is.
    void showWhole(const std::vector<editing::Element>& elements);
    void lookAlong(const geometry::Vector& toward); // keeps what is in the middle
    void levelHorizon(); // rolls the picture until what is upright in the world is so in it
    // The scene's view of that name; "" leaves it where it is.
    void followView(const QString& name);
    [[nodiscard]] const QString& followedView() const { return seen_.followed; }
    [[nodiscard]] const QString& lastView() const { return seen_.last; } // that was followed
    // The centre of rotation becomes the vertex or handle near the pixel, else what is at
    // mid-depth.
    void centerAt(const QPointF& position);

    // --- for those who edit in it
    [[nodiscard]] PictureEditing& editing() { return editing_; }
    [[nodiscard]] Creating& creating() { return creating_; }
    [[nodiscard]] Pointing& pointing() { return pointing_; }
    [[nodiscard]] Selecting& selecting() { return selecting_; }
    [[nodiscard]] Throwing& throwing() { return throwing_; }
    [[nodiscard]] Meters& meters() { return meters_; }
    [[nodiscard]] const Gizmo& gizmo() const { return gizmo_; }
    [[nodiscard]] const FaultSigns& faultSigns() const { return faultSigns_; }
    [[nodiscard]] const Selecting& selecting() const { return selecting_; }
    // How long the arrow of a force, or a torque, of 1 is drawn.
    [[nodiscard]] double arrowLength(bool couple);
    [[nodiscard]] double massOf(std::size_t body) const; // 1 while it is not known
    // Of mass, now; its shape's origin where it has no mass.
    [[nodiscard]] geometry::Vector centerOf(std::size_t body) const override;
    [[nodiscard]] geometry::Vector centroidOf(std::size_t body) const; // in the body's frame
    [[nodiscard]] QString words() const { return editing_.words(); }
    // The handles that the display shows of the scene at this time; as of the last picture, where a
    // newer one takes long, and none of another scene.
    [[nodiscard]] const render::HandleSet& handles();
    // The picture is the one that was wished for last.
    [[nodiscard]] bool showsNewest() const { return picture_.isNewest(); }
    // The newest picture is asked for, and waited for as long as there is patience.
    void bringUpToDate() { picture_.bringUpToDate(); }
    // The picture is of the scene that the document shows.
    [[nodiscard]] bool showsScene() const {
        return picture_.last() && picture_.last()->of.shown.scene == document_.shown().scene;
    }
    // The things to see in the picture as it is.
    [[nodiscard]] const render::HandleSet& drawnHandles() const override;
    // The same, as far as it is of the scene that is shown.
    [[nodiscard]] const render::HandleSet& knownHandles() const;
    [[nodiscard]] render::Drawing drawing() const;
    // The same as the picture shows it, whose time and motion may be older ones where a picture
    // takes long: what is painted over it, and what one clicks in it.
    [[nodiscard]] render::Drawing drawn() const override;
    // Where the grid of the scene that is shown lies; none: none is seen.
    [[nodiscard]] std::optional<render::GroundPlane> ground() const;
    // The direction of the triad's end there, as words: "x", "against y"; "": none is there.
    [[nodiscard]] QString triadEndAt(const QPointF& position) const;
    [[nodiscard]] QWidget& widget() override { return *this; }
    [[nodiscard]] gestures::Sight sight() const override {
        return {control_.camera(), pixelSize()};
    }
    [[nodiscard]] Eigen::Vector2d inPixels(const QPointF& position) const {
        return picture_.inPixels(position);
    }
    [[nodiscard]] QPointF fromPixels(const Eigen::Vector2d& pixels) const override {
        return picture_.fromPixels(pixels);
    }
    // The place of a point of the world, in the widget.
    [[nodiscard]] Q_INVOKABLE QPointF placeOf(double x, double y, double z) const;
    void keepCamera(); // it does not frame the scene by itself any more

    [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

Q_SIGNALS:
    void cameraChanged();
    void pictured();      // a newer picture is there
    void handleDragged(); // its words changed
    void hiddenChanged();
    void viewFollowed(); // another named view, or none any more
    void menuWanted(const MenuPlace& place);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] render::Size pixelSize() const { return picture_.pixelSize(); }
    void sceneChanged();
    void motionChanged();
    void rename(const std::vector<editing::Renamed>& renamed); // of what is hidden
    [[nodiscard]] PictureWish wish() const;
    // The picture is seen from the place where the display is to be: nobody has moved that
    // meanwhile.
    [[nodiscard]] bool isWanted(const Picture& picture) const;
    [[nodiscard]] bool isFollowed(const Picture& picture) const;
    void stayHere();
    void taken();
    void movedByUser();
    void redraw(bool moving) { picture_.redraw(moving); }
    void frame(const render::Extent& extent);
    void turnTo(const render::Camera& camera, bool mayFrame); // all that is framed stays in sight
    void keepFrame();                                         // the view is as something framed it
    void keepInSight();                                       // bodies, where they start
    void stepBack(); // as far as bodies need that grew out of the reader's own view
    void stepBackFor(const std::vector<editing::Element>& elements);
    void stepBackTo(const render::Camera& camera); // no move of the reader's: framed stays framed
    bool clickTriad(const QMouseEvent& event);
    bool turnKey(const QKeyEvent& event);
    void pressView(render::CameraControl::Button button, const QPointF& position);
    void moveView(QMouseEvent& event);
    bool beginDrag(QMouseEvent& event); // of a body; false: the view moves
    [[nodiscard]] std::vector<geometry::Vector> verticesAndHandles();

    // The chooser of the place that the scene is seen from: the display itself, until the user
    // moves the view. While one edits, the view stays, and steps back only as far as bodies need
    // that came or grew.
    struct Seen {
        bool framesItself = true;
        bool isEdited = false;       // the scene came of the one before by an edit
        bool isAnother = false;      // the next scene is one that was opened, no edit
        bool isDue = false;          // the next picture frames all of the motion, edited or not
        bool turned = false;         // framed anew, with the attitude as it is
        bool isWhole = false;        // it was framed, and only turned by a key since
        bool isPlaced = false;       // its bodies were seen, since it was opened
        bool keepsGround = false;    // the grid stays where it is, framed anew where it fits
        bool isToStay = false;       // once the scene is framed, the view stays
        bool keepsDirection = false; // the reader has chosen it, or has seen it
        unsigned scaling = 0;        // how often the reader has framed anew
        render::Display framing;     // whose handles it frames, too
        QString followed, last;      // views of the scene
        // The view as something framed it, and the picture's size then; none: the reader has moved
        // it since.
        std::optional<std::pair<render::Camera, render::Size>> framed = {};
    };
    struct Press {
        QPointF at;          // where the button was
        bool isDrag = false; // the pointer has left that place
        bool turns = false;  // it has moved the view, which shows its centre of rotation
    };

    SceneDocument& document_;
    WindowPicture picture_;
    render::CameraControl control_;
    render::Display display_;
    double time_ = 0;
    Seen seen_;
    PictureEditing editing_;
    Creating creating_;
    Pointing pointing_;
    Selecting selecting_;
    Throwing throwing_;
    Gizmo gizmo_;
    FaultSigns faultSigns_;
    mutable Centroids centroids_;
    Meters meters_;
    Press press_;
};

} // namespace views
