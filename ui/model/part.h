#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "case-file/verdict.h"
#include "plot/model/figure.h"
#include "text/result_row.h"

namespace ravnoves {

/// Something that a page shows: a plot, a table, lines of text. Variants, tolerances, report and
/// clipboard know it by its word and have no line in the scene.
struct PagePart {
    std::string_view id;
    std::string_view tab = {};  ///< name of the tab that it is on; empty: beside them
    bool hasBand = true;        ///< what takes longer than a frame has none
    bool isAnswer = false;      ///< side by side with other variants, and copied
};

/// Lines of text, each with its meaning for the answer.
struct Notes {
    std::vector<std::pair<Severity, QString>> lines;

    /// Each line of a text for itself.
    static Notes of(Severity severity, const QString& text) {
        Notes notes;
        notes.say(severity, text.split(QLatin1Char('\n')));
        return notes;
    }
    /// Nothing where there is no text.
    void say(Severity severity, const QString& text) {
        if (!text.isEmpty()) {
            lines.emplace_back(severity, text);
        }
    }
    void say(Severity severity, const QStringList& texts) {
        for (const QString& text : texts) {
            say(severity, text);
        }
    }
};

/// What the tolerances do to the numbers of a part: from 5 % to each number, and from it to 95 %.
struct PartSpread {
    plot::Spreads curves;           ///< of a figure
    std::vector<CellSpread> cells;  ///< of a table
    QString how;                    ///< they were found
};

/// What a part shows of one input; nothing where it does not exist.
using Content = std::variant<std::monostate, Figure, Results, Notes>;

/// A part, and what makes it of a scene's model. A scene has one array of them, in the order of the
/// page.
template <typename Model>
struct PartMaker {
    PagePart part;
    Content (*make)(const Model& model);
};

/// Such a maker's function from one that returns a figure, a table or notes, or from a member of
/// the model that does.
template <auto make, typename Model>
Content made(const Model& model) {
    return std::invoke(make, model);
}

template <typename Makers>
std::span<const PagePart> partsOf(const Makers& makers) {
    static const std::vector<PagePart> parts = [&] {
        std::vector<PagePart> all;
        for (const auto& maker : makers) {
            all.push_back(maker.part);
        }
        return all;
    }();
    return parts;
}

/// Makes the part with this word; empty without one.
template <typename Makers, typename Model>
Content makePart(const Makers& makers, const Model& model, std::string_view id) {
    for (const auto& maker : makers) {
        if (maker.part.id == id) {
            return maker.make(model);
        }
    }
    return {};
}

}  // namespace ravnoves
