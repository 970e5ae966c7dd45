#include "plain/qt_messages.h"

#include "terminal/terminal.h"

#include <QString>
#include <QtGlobal>

namespace plain {

namespace {

const char* before = "";
QtMessages wanted = QtMessages::all;

void print(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (wanted == QtMessages::errors && type != QtCriticalMsg && type != QtFatalMsg)
        return;
    terminal::complain(before + std::string(": ") +
                       qFormatLogMessage(type, context, text).toStdString());
}

} // namespace

void printQtMessages(const char* program, QtMessages which) {
    before = program;
    wanted = which;
    qInstallMessageHandler(print);
}

} // namespace plain
