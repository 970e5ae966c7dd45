// A shape from an STL or OBJ file: the convex parts that it would become are shown, and how many
// they are, before anything of the scene changes.
#pragma once

#include "painting/picture_thread.h"
#include "shapes/mesh_job.h"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace views {

class SceneDocument;
class ShapeDisplay;

// About how many bytes these parts take in a text, without writing it.
[[nodiscard]] double lengthInText(const std::vector<scene::Part>& parts);

class ShapeImport : public QDialog {
    Q_OBJECT
public:
    ShapeImport(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                const QString& path, QWidget* parent = nullptr);

    // The parts as they would be in the text.
    [[nodiscard]] std::vector<scene::Part> parts() const;
    [[nodiscard]] QString words() const; // what is said of them
    [[nodiscard]] bool ready() const;
    void useFewer();
    void accept() override;

Q_SIGNALS:
    void imported(const QString& shape);

private:
    QWidget* buildSide();
    void buildWishes(QFormLayout* form);
    void ask(); // for other parts
    void showResult(const MeshResult& result);
    void showParts();
    void showFault(); // or what they are
    [[nodiscard]] QString sizeText() const;
    [[nodiscard]] QString resultText() const;
    [[nodiscard]] QString faultOfLength() const; // "": it fits

    SceneDocument& document_;
    QString file_;
    MeshJob job_;
    std::vector<scene::Part> made_; // as they are shown; none: there are none
    QString tooLong_;
    ShapeDisplay* display_;
    QLabel *facts_, *size_, *words_;
    QLineEdit *name_, *scale_;
    QCheckBox* centred_;
    QDoubleSpinBox* surplus_;
    QSpinBox *parts_, *points_;
    QProgressBar* progress_;
    QPushButton *fewer_, *import_ = nullptr;
};

// Asks for a file and opens the dialog for it, beside `parent`.
ShapeImport* importShape(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                         QWidget* parent);

} // namespace views
