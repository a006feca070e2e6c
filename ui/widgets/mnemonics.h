#pragma once

#include <QString>

class QWidget;

namespace ravnoves {

/// The label with a mnemonic that is not used yet, which it becomes: the first letter of a word
/// where one is free, else any letter of the keyboard; unchanged without one.
QString withMnemonic(QString label, QString& used);

/// Gives texts of a page that have the same mnemonic other ones: the first keeps its letter, after
/// the window's menus. Texts around the tabs precede those in a tab; between tabs Qt moves from one
/// to the next.
void separateMnemonics(QWidget* page);

}  // namespace ravnoves
