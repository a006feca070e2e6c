#include "report/case_report.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "bibliography/bibliography.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "model/input_differences.h"
#include "model/variant_results.h"
#include "page/scene_page.h"
#include "report/case_parts.h"
#include "report/input_tables.h"
#include "report/report.h"
#include "report/report_dialog.h"
#include "report/study_section.h"
#include "scenes/scenes.h"
#include "text/language.h"
#include "text/message_text.h"
#include "text/write_file.h"
#include "theme/theme.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

using namespace report;

namespace {

/// A text of the user's that may have any length.
QString shortened(const QString& text) {
    constexpr qsizetype longest = 400;
    return text.size() <= longest ? text : text.left(longest) + QChar(0x2026);
}

/// Paper is white: the page is drawn in the light theme meanwhile.
class LightTheme {
  public:
    explicit LightTheme(QWidget* window)
        : window_(window), mode_(Theme::instance().mode()), changes_(Theme::instance().isDark()) {
        QApplication::setOverrideCursor(Qt::WaitCursor);
        window_->setUpdatesEnabled(false);
        if (changes_) {
            Theme::instance().setMode(Theme::Mode::Light);
        }
    }
    ~LightTheme() {
        if (changes_) {
            Theme::instance().setMode(mode_);
        }
        window_->setUpdatesEnabled(true);
        QApplication::restoreOverrideCursor();
    }
    Q_DISABLE_COPY_MOVE(LightTheme)

  private:
    QWidget* window_;
    Theme::Mode mode_;
    bool changes_;
};

/// The case as its file holds it, or would hold it; as text what it is of.
std::pair<QString, QString> fingerprint(CaseDocument& document) {
    const bool isFile = !document.path().isEmpty() && !document.needsSaving();
    if (isFile && !document.disk().digest().isEmpty()) {
        return {document.disk().check() == FileOnDisk::State::Same
                    ? ReportWords::tr("SHA-256 of the file")
                    : ReportWords::tr("SHA-256 of the file as read; the file has changed"),
                QString::fromLatin1(document.disk().digest().toHex())};
    }
    const auto text = QByteArray::fromStdString(document.asText(document.path()));
    return {
        ReportWords::tr("SHA-256 of the case, with changes that are not saved"),
        QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex())};
}

void addCase(Report& report, const SceneModel& model, CaseDocument& document) {
    report.head(ReportWords::tr("Case"));
    Table table;
    const auto row = [&](const QString& name, const QString& value) {
        table.rows << QStringList{name.toHtmlEscaped(), value.toHtmlEscaped()};
    };
    row(ReportWords::tr("Module"), model.sceneTitle());
    if (!document.path().isEmpty()) {
        row(ReportWords::tr("Case file"), QFileInfo(document.path()).fileName());
    }
    const auto [name, sum] = fingerprint(document);
    row(name, sum);
    row(ReportWords::tr("Program"), report.program);
    row(ReportWords::tr("Date"), report.date);
    report.items.push_back(std::move(table));
    if (!model.notes().isEmpty()) {
        report.head(ReportWords::tr("Notes"));
        for (const QString& line : model.notes().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            report.say(line);
        }
    }
}

void addResults(Report& report, std::vector<PageGroup> groups) {
    report.head(ReportWords::tr("Plots and tables"));
    for (PageGroup& group : groups) {
        if (group.isEmpty()) {
            continue;
        }
        if (!group.title.isEmpty()) {
            report.head(group.title, 2);
        }
        for (auto* part : {&group.words, &group.tables, &group.figures}) {
            std::move(part->begin(), part->end(), std::back_inserter(report.items));
        }
    }
}

void addTheory(Report& report, const SceneModel& model) {
    const auto scenes = scene_solvers();
    const std::string name = model.sceneName().toStdString();
    const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const SceneSolver& each) { return each.name == name; });
    if (scene == scenes.end()) {
        return;
    }
    report.head(ReportWords::tr("Formulas"));
    Table table;
    table.headings = {ReportWords::tr("Quantity"), ReportWords::tr("Formula"),
                      ReportWords::tr("Source")};
    std::vector<std::string_view> cited;
    for (const Formula& formula : scene->formulas(model.inputJson())) {
        QString from = ReportWords::tr("derived, see Help (F1)");
        if (!formula.source.empty()) {
            if (std::find(cited.begin(), cited.end(), formula.source) == cited.end()) {
                cited.push_back(formula.source);
            }
            from = shownText(source(formula.source).cited_as);
            if (!formula.equation.empty()) {
                from += QLatin1Char(' ') + shownEquation(formula.equation);
            } else {
                from += ReportWords::tr(", not numbered there");
            }
        }
        QString text =
            QString::fromUtf8(formula.html.data(), static_cast<qsizetype>(formula.html.size()));
        if (!formula.where.empty()) {
            text += QStringLiteral("<br/><small>%1</small>")
                        .arg(shownText(formula.where).toHtmlEscaped());
        }
        table.rows << QStringList{shownText(formula.name).toHtmlEscaped(), text,
                                  from.toHtmlEscaped()};
    }
    report.items.push_back(std::move(table));
    for (const std::string_view key : cited) {
        report.say(messageText(citation(source(key))), Paragraph::Kind::Muted);
    }
    report.head(ReportWords::tr("What the model leaves out"));
    for (const Text& text : scene->left_out()) {
        report.say(QStringLiteral("– ") + shownText(text));
    }
}

/// The present case and its variants, as far as they differ.
void addVariants(Report& report, const SceneModel& model) {
    if (model.variants().isEmpty()) {
        return;
    }
    report.head(ReportWords::tr("Variants"));
    const auto [verdicts, results, troubles] = variantResults(model);
    QStringList others;  // that of the present case is the first of all
    for (const QString& verdict : verdicts.mid(1)) {
        others << shortened(verdict).toHtmlEscaped();
    }
    report.items.push_back(Paragraph{others.join(QStringLiteral("<br/>")), Paragraph::Kind::Muted});
    for (const QString& trouble : troubles) {
        report.say(shortened(trouble), Paragraph::Kind::Warning);
    }
    Table table;
    for (const ResultColumn& column : results.columns) {
        table.numbers << !table.headings.isEmpty();
        table.headings << column.heading.toHtmlEscaped();
    }
    for (const ResultRow& row : results.rows) {
        const bool differs = std::any_of(row.begin() + 1, row.end(), [&](const ResultCell& cell) {
            return cell.text != row[1].text;
        });
        QStringList cells;
        for (const ResultCell& cell : row) {
            const QString difference =
                cell.fromOther ? QStringLiteral(" (%1)").arg(cell.fromOther->absolute) : QString();
            cells << shortened(cell.marked() + difference).toHtmlEscaped();
        }
        if (differs) {
            table.rows << cells;
        }
    }
    table.isSmall = results.columns.size() > 4;
    report.items.push_back(std::move(table));
    QString how = ReportWords::tr(
        "Only differences are listed, inputs first; in brackets the difference from the reference. "
        "★ marks the best of those without a warning.");
    if (model.reference() >= 0) {
        how +=
            QLatin1Char(' ') + ReportWords::tr("In the plots the curves of %1 are dimmed and wide.")
                                   .arg(shortened(model.variants().at(model.reference()).name));
    }
    report.say(how, Paragraph::Kind::Muted);
}

/// The answer: what holds, the picture, the leading results.
void addAnswer(Report& report, const SceneModel& model, PageGroup& answer) {
    if (const std::optional<Verdict> verdict = model.verdictShown()) {
        report.say(
            severityName(verdict->severity) + QStringLiteral(": ") + messageText(verdict->text),
            kindOf(verdict->severity));
    }
    if (const QString design = designText(model); !design.isEmpty()) {
        report.say(design);
    }
    for (auto* part : {&answer.words, &answer.figures, &answer.tables}) {
        std::move(part->begin(), part->end(), std::back_inserter(report.items));
    }
}

Report makeReport(ScenePage& page, CaseDocument& document, const Patience& patience) {
    SceneModel& model = *page.model();
    const ReportChoice choice;
    Report report;
    report.program = QStringLiteral("Ravnoves " RAVNOVES_VERSION);
    report.date = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    report.language = currentLanguage();
    report.paper = choice.paper;
    report.title =
        model.title().isEmpty() ? model.sceneTitle() : shortened(model.titleShown().simplified());
    report.subtitle = ReportWords::tr("Report of a calculation: %1").arg(model.sceneTitle());
    const Patience ofParts = patience.of(0.0, model.study().empty() ? 0.9 : 0.7);
    auto [answer, groups] = caseParts(page, ofParts);
    addAnswer(report, model, answer);
    addVariants(report, model);
    if (!model.study().empty()) {
        patience.tell(ReportWords::tr("Tolerances"), 0.7);
    }
    addTolerances(report, model, patience);
    if (choice.inputs) {
        report.head(ReportWords::tr("Inputs"));
        for (Table& table : inputTables(model)) {
            report.items.push_back(std::move(table));
        }
        if (std::optional<Table> missing = leftOut(model)) {
            report.items.push_back(std::move(*missing));
        }
    }
    if (choice.plots) {
        addResults(report, std::move(groups));
    }
    if (choice.formulas) {
        addTheory(report, model);
    }
    addCase(report, model, document);
    patience.tell(ReportWords::tr("Pages"), 0.95);
    return report;
}

bool isPdf(const QString& path) {
    return path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
}

}  // namespace

bool isReportName(const QString& path) {
    return isPdf(path) || path.endsWith(QLatin1String(".html"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".htm"), Qt::CaseInsensitive);
}

QString writeReport(ScenePage& page, CaseDocument& document, const QString& path,
                    const Patience& patience) {
    if (!isReportName(path)) {
        return ReportWords::tr("%1: the name of a report ends in .pdf or .html").arg(path);
    }
    QString source = sourceTrouble(path);
    if (!source.isEmpty()) {
        return source;
    }
    return writeFile(path, [&] {
        const LightTheme light(page.window());
        const Report report = makeReport(page, document, patience);
        return (isPdf(path) ? reportAsPdf(report) : reportAsHtml(report)).toStdString();
    });
}

}  // namespace ravnoves
