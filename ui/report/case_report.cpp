#include "report/case_report.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>
#include <QScopeGuard>
#include <algorithm>
#include <cmath>

#include "bibliography/bibliography.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "model/input_differences.h"
#include "model/variant_results.h"
#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "report/report_dialog.h"
#include "report/sections.h"
#include "scenes/scenes.h"
#include "text/language.h"
#include "text/message_text.h"
#include "text/write_file.h"
#include "theme/theme.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

using namespace paper;

namespace {

/// A text of the user's that may have any length.
QString shortened(const QString& text) {
    constexpr qsizetype longest = 400;
    return text.size() <= longest ? text : text.left(longest) + QChar(0x2026);
}

/// The case as its file holds it, or would hold it; as text what it is of.
std::pair<QString, QString> fingerprint(CaseDocument& document) {
    const bool isFile = !document.path().isEmpty() && !document.needsSaving();
    if (isFile && !document.disk().digest().isEmpty()) {
        document.checkFiles();
        return {document.disk().isSame()
                    ? ReportWords::tr("SHA-256 of the file")
                    : ReportWords::tr("SHA-256 of the file as read; the file has changed"),
                QString::fromLatin1(document.disk().digest().toHex())};
    }
    const auto text = QByteArray::fromStdString(document.asText(document.path()));
    return {
        ReportWords::tr("SHA-256 of the case, with changes that are not saved"),
        QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex())};
}

void addCase(Paper& report, const SceneModel& model, CaseDocument& document, const QString& date) {
    report.body += heading(ReportWords::tr("Case"));
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
    row(ReportWords::tr("Program"), QStringLiteral("Ravnoves " RAVNOVES_VERSION));
    row(ReportWords::tr("Date"), date);
    report.body += paper::table(table);
    if (!model.notes().isEmpty()) {
        report.body += heading(ReportWords::tr("Notes"));
        for (const QString& line : model.notes().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            report.say(line);
        }
    }
}

void addResults(Paper& report, const std::vector<PageGroup>& groups) {
    report.body += heading(ReportWords::tr("Plots and tables"));
    for (const PageGroup& group : groups) {
        const QString content = group.words + group.tables + group.figures;
        if (!content.isEmpty() && !group.title.isEmpty()) {
            report.body += heading(group.title, 2);
        }
        report.body += content;
    }
}

/// The place of a formula in its source, "(3)", "Table 1", in the language of the program.
QString shownEquation(std::string_view equation) {
    return QString::fromUtf8(equation.data(), static_cast<qsizetype>(equation.size()))
        .replace(QLatin1String("Table"), ReportWords::tr("Table"))
        .replace(QLatin1String("Fig."), ReportWords::tr("Fig."));
}

void addTheory(Paper& report, const SceneModel& model) {
    const SceneSolver& scene = scene_solver(model.sceneName().toStdString());
    report.body += heading(ReportWords::tr("Formulas"));
    Table table;
    table.headings = {ReportWords::tr("Quantity"), ReportWords::tr("Formula"),
                      ReportWords::tr("Source")};
    std::vector<std::string_view> cited;
    for (const Formula& formula : scene.formulas(model.inputJson())) {
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
    report.body += paper::table(table);
    for (const std::string_view key : cited) {
        report.say(messageText(citation(source(key))), Tone::Muted);
    }
    report.body += heading(ReportWords::tr("What the model leaves out"));
    for (const Text& text : scene.left_out()) {
        report.say(QStringLiteral("– ") + shownText(text));
    }
}

/// The present case and its variants, as far as they differ.
void addVariants(Paper& report, const SceneModel& model) {
    if (model.variants().isEmpty()) {
        return;
    }
    report.body += heading(ReportWords::tr("Variants"));
    const auto [verdicts, results, troubles] = variantResults(model);
    QStringList others;  // that of the present case is the first of all
    for (const QString& verdict : verdicts.mid(1)) {
        others << shortened(verdict).toHtmlEscaped();
    }
    report.body += paragraph(others.join(QStringLiteral("<br/>")), Tone::Muted);
    for (const QString& trouble : troubles) {
        report.say(shortened(trouble), Tone::Warning);
    }
    Results shown{results.columns};
    for (ResultRow row : results.rows) {
        const bool differs = std::any_of(row.begin() + 1, row.end(), [&](const ResultCell& cell) {
            return cell.text != row[1].text;
        });
        for (ResultCell& cell : row) {
            const QString difference =
                cell.fromOther ? QStringLiteral(" (%1)").arg(cell.fromOther->absolute) : QString();
            cell.text = shortened(cell.text + difference);
        }
        if (differs) {
            shown.rows << row;
        }
    }
    Table table = tableOf(shown);
    table.isSmall = results.columns.size() > 4;
    report.body += paper::table(table);
    QString how = ReportWords::tr(
        "Only differences are listed, inputs first; in brackets the difference from the reference. "
        "★ marks the best of those without a warning.");
    if (model.reference() >= 0) {
        how +=
            QLatin1Char(' ') + ReportWords::tr("In the plots the curves of %1 are dimmed and wide.")
                                   .arg(shortened(model.variants().at(model.reference()).name));
    }
    report.say(how, Tone::Muted);
}

/// The answer: what holds, the picture, the leading results.
void addAnswer(Paper& report, ScenePage& page, const PageGroup& answer) {
    const SceneModel& model = *page.model();
    if (QString rejected = rejectedWords(&page); !rejected.isEmpty()) {
        // A verdict on values that are to be others is none.
        report.say(rejected.replace(QStringLiteral("\n\n"), QStringLiteral(" "))
                       .replace(QLatin1Char('\n'), QStringLiteral("; ")),
                   Tone::Error);
    } else if (const std::optional<Verdict> verdict = model.verdictShown()) {
        report.say(
            severityName(verdict->severity) + QStringLiteral(": ") + messageText(verdict->text),
            toneOf(verdict->severity));
    }
    if (const QString design = designText(model); !design.isEmpty()) {
        report.say(design);
    }
    report.body += answer.words + answer.figures + answer.tables;
}

Paper makeReport(ScenePage& page, CaseDocument& document, const ReportChoice& choice,
                 const Patience& patience) {
    SceneModel& model = *page.model();
    const QString date = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    Paper report;
    report.title =
        model.title().isEmpty() ? model.sceneTitle() : shortened(model.titleShown().simplified());
    report.foot = QStringLiteral("Ravnoves " RAVNOVES_VERSION " · ") + date;
    report.pageOf = ReportWords::tr("Page %1 of %2");
    report.language = currentLanguage();
    report.body = heading(report.title, 0) + QStringLiteral("<p class=\"kind\">%1</p>\n")
                                                 .arg(ReportWords::tr("Report of a calculation: %1")
                                                          .arg(model.sceneTitle())
                                                          .toHtmlEscaped());
    const auto [answer, groups] = caseParts(page, report, patience);
    addAnswer(report, page, answer);
    addVariants(report, model);
    addTolerances(report, model, patience);
    if (choice.inputs) {
        report.body += heading(ReportWords::tr("Inputs"));
        for (const Table& each : inputTables(model)) {
            report.body += table(each);
        }
        report.body += table(leftOut(model));
    }
    if (choice.plots) {
        addResults(report, groups);
    }
    if (choice.formulas) {
        addTheory(report, model);
    }
    addCase(report, model, document, date);
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
        // Paper is white: the page is drawn in the light theme meanwhile, unseen.
        Theme& theme = Theme::instance();
        QApplication::setOverrideCursor(Qt::WaitCursor);
        page.window()->setUpdatesEnabled(false);
        const auto restore = qScopeGuard([&, mode = theme.mode(), wasDark = theme.isDark()] {
            if (wasDark) {
                theme.setMode(mode);
            }
            page.window()->setUpdatesEnabled(true);
            QApplication::restoreOverrideCursor();
        });
        if (theme.isDark()) {
            theme.setMode(Theme::Mode::Light);
        }
        const ReportChoice choice;
        const Paper report = makeReport(page, document, choice, patience);
        return (isPdf(path) ? paperAsPdf(report, QPageSize(choice.paper)) : paperAsHtml(report))
            .toStdString();
    });
}

}  // namespace ravnoves
