#pragma once

#include <QString>

class QWidget;

namespace ravnoves {

/// The label with a mnemonic that is not used yet, which it becomes: the first letter of a word
/// where one is free, else any letter of the keyboard; as it is where none is.
QString withMnemonic(QString label, QString& used);

/// Keeps the mnemonics apart that can be seen on a page at the same time, in whatever language and
/// with whichever tabs in front: the first keeps its letter, and gives way to the window's menus
/// alone; another gets a free letter of its own text, or none. What stands beside and over tabs
/// comes before what is in them: its letters rest when the tabs change.
void keepMnemonicsApart(QWidget* page);

}  // namespace ravnoves
