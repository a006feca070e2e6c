#include "report/page_parts.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QPointer>
#include <QResizeEvent>
#include <QScopeGuard>
#include <QTabWidget>
#include <algorithm>
#include <cmath>

#include "model/background_job.h"
#include "model/scene_model.h"
#include "page/mechanism_picture.h"
#include "page/scene_page.h"
#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "report/figure_drawings.h"
#include "report/patience.h"
#include "studies/tolerance_bands.h"
#include "studies/tolerance_switch.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace report;

namespace {

constexpr qint64 patience = 60'000;  // ms
constexpr double bandsShare = 0.8;   ///< of the time that the parts of the page take

/// A plain text as a fragment of HTML.
QString fragment(const QString& text) {
    return text.toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br/>"));
}

/// A label's: only one that says so is HTML already.
QString fragment(const QLabel& label) {
    return label.textFormat() == Qt::RichText
               ? label.text().replace(QLatin1String("<br>"), QLatin1String("<br/>"))
               : fragment(label.text());
}

Paragraph::Kind kindOf(const QLabel& label) {
    const Ink ink = inkOf(label);
    return ink == &Theme::error       ? Paragraph::Kind::Error
           : ink == &Theme::warning   ? Paragraph::Kind::Warning
           : ink == &Theme::good      ? Paragraph::Kind::Good
           : ink == &Theme::mutedText ? Paragraph::Kind::Muted
                                      : Paragraph::Kind::Text;
}

class Collector {
  public:
    Collector(ScenePage& page, const Patience& patience) : page_(page), patience_(patience) {
        groups_.emplace_back();
    }

    std::vector<PageGroup> collect() {
        auto* bands = page_.findChild<ToleranceBands*>(QString(), Qt::FindDirectChildrenOnly);
        if (bands == nullptr || page_.model()->study().empty() ||
            !ToleranceSwitch::instance().isOn()) {
            bands = nullptr;
        }
        const auto release = qScopeGuard([bands = QPointer(bands)] {
            if (bands) {
                bands->hold(false);
            }
        });
        if (bands != nullptr) {
            findBands(bands);
        } else {
            wait();
        }
        for (const QTabWidget* tabs : page_.findChildren<QTabWidget*>()) {
            tabs_ += tabs->count();
        }
        walk(&page_, 0);
        return std::move(groups_);
    }

  private:
    /// Those of all tabs at once: each sample is solved once rather than for each tab.
    void findBands(ToleranceBands* bands) {
        bands->hold(true);
        wait();
        fillTabs(&page_);
        bands->findAll();
        const QObject told;
        QObject::connect(bands->job(), &BackgroundJob::progress, &told, [this](double part) {
            patience_.tell(ReportWords::tr("Samples of the tolerances"), bandsShare * part);
        });
        constexpr qint64 forAll = 4;
        wait(forAll * patience);
    }

    /// Each tab is shown once.
    void fillTabs(QWidget* widget) {
        if (auto* tabs = qobject_cast<QTabWidget*>(widget)) {
            eachTab(tabs, [&](int i) { fillTabs(tabs->widget(i)); });
        } else {
            eachBelow(widget, [&](QWidget* below) { fillTabs(below); });
        }
    }

    /// Brings one tab after the other to the front, and back the one that was there.
    template <typename Look>
    void eachTab(QTabWidget* tabs, const Look& look) {
        const auto bringBack =
            qScopeGuard([tabs, front = tabs->currentIndex()] { tabs->setCurrentIndex(front); });
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->isTabVisible(i) && tabs->isTabEnabled(i)) {
                tabs->setCurrentIndex(i);
                wait();
                look(i);
            }
        }
    }

    /// What is shown directly in a widget.
    template <typename Look>
    static void eachBelow(const QWidget* widget, const Look& look) {
        // Events that are handled meanwhile may take some away.
        QList<QPointer<QWidget>> children;
        for (QObject* child : widget->children()) {
            children << qobject_cast<QWidget*>(child);
        }
        for (const QPointer<QWidget>& below : children) {
            if (below && !below->isHidden() && !below->isWindow()) {
                look(below);
            }
        }
    }

    void wait(qint64 longest = patience) const {
        QElapsedTimer waited;
        waited.start();
        // Layout, then what a shown tab computes.
        for (int turn = 0; turn < 3; ++turn) {
            patience_.wait();
        }
        while (page_.isBusy() && waited.elapsed() < longest) {
            patience_.wait(50);
        }
        patience_.wait();
    }

    void walk(QWidget* widget, std::size_t group) {
        if (auto* tabs = qobject_cast<QTabWidget*>(widget)) {
            walkTabs(tabs, group);
            return;
        }
        if (take(widget, group)) {
            return;
        }
        eachBelow(widget, [&](QWidget* below) { walk(below, group); });
    }

    void walkTabs(QTabWidget* tabs, std::size_t group) {
        eachTab(tabs, [&](int i) {
            const std::size_t own = groups_.size();
            QString title = tabs->tabText(i).remove(QLatin1Char('&'));
            patience_.tell(title, std::lerp(bandsShare, 1.0,
                                            static_cast<double>(seen_) / std::max(tabs_, seen_)));
            ++seen_;
            if (group > 0) {
                title = groups_[group].title + QStringLiteral(": ") + title;
            }
            groups_.push_back({title, {}, {}, {}, {}});
            walk(tabs->widget(i), own);
        });
    }

    /// @return true where nothing below the widget is looked at
    bool take(QWidget* widget, std::size_t group) {
        PageGroup& parts = groups_[group];
        if (auto* plot = qobject_cast<PlotView*>(widget)) {
            // A head alone, without a row.
            if (plot->dataAsCsv().count(QLatin1Char('\n')) > 1) {
                parts.figures.push_back(drawingOf(plot));
            } else {
                parts.empty << plot->title();
            }
            return true;
        }
        if (isFigure(widget)) {
            parts.figures.push_back(drawingOf(widget));
            return true;
        }
        if (const auto* table = qobject_cast<ResultTable*>(widget)) {
            if (table->rowCount() > 0) {
                parts.tables.push_back(tableOf(*table));
            }
            return true;
        }
        if (const auto* label = qobject_cast<QLabel*>(widget)) {
            takeLabel(*label, parts);
            return true;
        }
        return false;
    }

    void takeLabel(const QLabel& label, PageGroup& parts) {
        const bool isSelectable = label.textInteractionFlags().testFlag(Qt::TextSelectableByMouse);
        if (!isSelectable || label.text().isEmpty()) {
            return;
        }
        if (qobject_cast<const FormSection*>(label.parentWidget()) != nullptr &&
            !label.accessibleName().isEmpty()) {
            parts.words.push_back(Paragraph{QStringLiteral("%1: %2").arg(
                label.accessibleName().toHtmlEscaped(), fragment(label))});
            return;
        }
        parts.words.push_back(Paragraph{fragment(label), kindOf(label)});
    }

    ScenePage& page_;
    const Patience& patience_;
    std::vector<PageGroup> groups_;
    int tabs_ = 0;
    int seen_ = 0;
};

}  // namespace

std::vector<PageGroup> pageParts(ScenePage& page, const Patience& patience) {
    return Collector(page, patience).collect();
}

}  // namespace ravnoves
