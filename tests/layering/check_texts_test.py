#!/usr/bin/env python3
"""check_texts.py finds what it is for, and nothing else."""
import unittest

from check_texts import violations

BAD = """auto* a = new QLabel(text);
QMessageBox::warning(this, tr("Save"), sentence);
item->setToolTip(1, fault.message);
QToolTip::showText(place, why, this);
setWindowTitle(file + "[*]");
menu->addAction(name, this, [] {});
QAction* b = menu->addAction(label);
group = menu->addMenu(QString::fromStdString(entry.group));
auto* c = new QPushButton(text);
c->setText(tr("&Undo %1").arg(label));
box.addButton(QMessageBox::Apply)->setText(update);
box.setInformativeText(text);
button->setToolTip(playing ? tr("Pause") : name);"""
GOOD = """QLabel* a = plain::label(text);
plain::Message::tell(QMessageBox::Warning, this, tr("Save"), sentence);
item->setToolTip(1, plain::tip(fault.message));
button->setToolTip(playing ? tr("Pause") : tr("Play"));
setWindowTitle(plain::title(file) + "[*]");
menu->addAction(tr("&Close"), this, [] {});
menu->addAction(action);
auto* c = new QPushButton(tr("&Update"));
c->setText(plain::caption(label));
field->setText(value);
a->setText(value);
QToolButton* addButton(QHBoxLayout* row, const QString& tip);"""


class Texts(unittest.TestCase):
    def test_every_bad_line_is_found(self):
        self.assertEqual(sorted({number for number, _ in violations("host/window/a.cpp", BAD, "")}),
                         list(range(1, BAD.count("\n") + 2)))

    def test_no_good_line_is(self):
        self.assertEqual(list(violations("host/window/a.cpp", GOOD, "QLabel* a;")), [])


if __name__ == "__main__":
    unittest.main()
