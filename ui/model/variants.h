#pragma once

#include <QList>
#include <QString>
#include <string>

namespace ravnoves {

struct CaseFile;

/// An input that is kept under a name beside the present one.
struct Variant {
    QString name;       ///< not empty, of one variant alone
    std::string input;  ///< the case's "input" object as JSON text; it may be rejected
    friend bool operator==(const Variant&, const Variant&) = default;
};

/// The variants of a case, and which of them the present input is seen against.
struct Variants {
    QList<Variant> list;
    int reference = -1;  ///< −1: none
    /// The choice of the one shown is no change of a case.
    friend bool operator==(const Variants& a, const Variants& b) { return a.list == b.list; }
};

/// What a case has beside its input.
struct CaseTexts {
    QString title = {};
    QString notes = {};
    Variants variants = {};
    std::string study = {};  ///< JSON text; empty without one
    friend bool operator==(const CaseTexts&, const CaseTexts&) = default;
};

CaseTexts textsOf(const CaseFile& file);

}  // namespace ravnoves
