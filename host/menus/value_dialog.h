// A value of a figure that is written into a text: of which figure, which value, at which time,
// with how many digits. It shows the number as it would stand there, or why there is none.
#pragma once

#include "authoring/authoring.h"
#include "document/value_use.h"
#include "media/live_subdocument.h"
#include "menus/reference_dialog.h"

#include <QDialog>
#include <QPointer>
#include <QTimer>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSpinBox;

namespace session {
class OpenDocument;
}

namespace menus {

// A figure whose medium may tell values. `described` by its caption, or by its name.
struct ValuedFigure {
    sgml::NodeId element = sgml::noNode; // the nested document
    document::SubdocumentId id = document::noSubdocument;
    QString words;
};
[[nodiscard]] std::vector<ValuedFigure> valuedFigures(const session::OpenDocument& document,
                                                      const authoring::Manuscript& in,
                                                      const model::Model& model);

class ValueDialog : public QDialog {
    Q_OBJECT

public:
    // `figures` are not empty; `now` is the value that is changed, or nothing but its digits.
    // `language`: of the text that it stands in.
    ValueDialog(session::OpenDocument& document, std::vector<ValuedFigure> figures,
                const document::ValueUse& now, std::string language, QWidget* parent);
    ~ValueDialog() override;

    [[nodiscard]] sgml::NodeId figure() const;
    [[nodiscard]] document::ValueUse use() const; // without its figure

    // When the figure has answered: not where the expression has a fault and the list has nothing
    // that fits.
    void accept() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    // Of the figure, about the expression as it stands; a figure that does not answer is no fault.
    enum class Answer { awaited, awaitedByOk, value, fault };
    void setAnswer(Answer answer);
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] bool isOffered(const QString& expression) const;
    void makeForm(const document::ValueUse& now);
    void chooseFigure();
    void askForOffers();
    void filter();
    void takeOffer();
    void look();
    void askForNumber();
    void show(const media::Outcome<ipc::Values>& outcome);
    [[nodiscard]] media::LiveSubdocument* live() const; // null: none

    session::OpenDocument& document_;
    std::vector<ValuedFigure> figures_;
    std::string language_;
    QPointer<media::LiveSubdocument> asked_; // the chosen one, whose process is wanted
    std::vector<ipc::ValueOffer> offers_;
    struct Form {
        QComboBox* figure;
        QLineEdit* expression;
        QListWidget* list;
        QLabel* number;
        QRadioButton* fixed;
        QDoubleSpinBox* time;
        QSpinBox* digits;
        QComboBox* unit;
        QPushButton* ok = nullptr;
    };
    Form form_;
    struct Time {
        std::optional<double> written; // with digits that the field does not show
        double shown = 0;              // by the field for it
    };
    Time at_;
    Answer answer_ = Answer::awaited;
    QTimer look_;
    int asking_ = 0; // which question is the last
};

} // namespace menus
