#include "report/case_report.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "bibliography/bibliography.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "methods/model/method_words.h"
#include "methods/model/validation_model.h"
#include "report/input_tables.h"
#include "report/page_parts.h"
#include "report/report.h"
#include "scenes/scenes.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/language.h"
#include "text/message_text.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace report;

namespace {

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

QString sceneTitle(const QString& name) {
    for (const SceneInfo& info : sceneList()) {
        if (info.name == name) {
            return info.title;
        }
    }
    return name;
}

/// The case as its file holds it, or would hold it; in words what it is of.
std::pair<QString, QString> fingerprint(const SceneModel& model, const QString& path) {
    const auto sum = [](const std::string& bytes) {
        return QString::fromLatin1(
            QCryptographicHash::hash(QByteArray::fromStdString(bytes), QCryptographicHash::Sha256)
                .toHex());
    };
    if (!path.isEmpty() && !model.hasChanges()) {
        try {
            return {ReportWords::tr("SHA-256 of the file"), sum(read_text_file(fsPath(path)))};
        } catch (const InputError&) {
            // The file went meanwhile; what it held is still known.
        }
    }
    return {ReportWords::tr("SHA-256 of the case, with changes that are not saved"),
            sum(write_case(model.caseFile()).dump(2) + "\n")};
}

void addCase(Report& report, const SceneModel& model, const QString& caseFile) {
    Table table;
    const auto row = [&](const QString& name, const QString& value) {
        table.rows << QStringList{name.toHtmlEscaped(), value.toHtmlEscaped()};
    };
    row(ReportWords::tr("Scene"), sceneTitle(model.sceneName()));
    if (!caseFile.isEmpty()) {
        row(ReportWords::tr("Case file"), QFileInfo(caseFile).fileName());
    }
    const auto [name, sum] = fingerprint(model, caseFile);
    row(name, sum);
    row(ReportWords::tr("Program"), report.program);
    row(ReportWords::tr("Date"), report.date);
    report.items.push_back(std::move(table));
    if (!model.notes().isEmpty()) {
        report.items.push_back(Heading{ReportWords::tr("Notes")});
        for (const QString& line : model.notes().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            report.items.push_back(Paragraph{line.toHtmlEscaped()});
        }
    }
}

void addResults(Report& report, std::vector<PageGroup> groups) {
    report.items.push_back(Heading{ReportWords::tr("Results")});
    for (PageGroup& group : groups) {
        if (group.isEmpty() && group.empty.isEmpty()) {
            continue;
        }
        if (!group.title.isEmpty()) {
            report.items.push_back(Heading{group.title, 2});
        }
        for (auto* part : {&group.words, &group.tables, &group.figures}) {
            std::move(part->begin(), part->end(), std::back_inserter(report.items));
        }
        if (!group.empty.isEmpty()) {
            report.items.push_back(Paragraph{
                ReportWords::tr("Left out, since this case gives them nothing to show: %1.")
                    .arg(group.empty.join(QStringLiteral(", ")))
                    .toHtmlEscaped(),
                Paragraph::Kind::Muted});
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
    report.items.push_back(Heading{ReportWords::tr("Formulas")});
    Table table;
    table.headings = {ReportWords::tr("Quantity"), ReportWords::tr("Formula"),
                      ReportWords::tr("Source")};
    std::vector<std::string_view> cited;
    for (const Formula& formula : scene->formulas(model.inputJson(), model.context())) {
        QString from = ReportWords::tr("mechanics");
        if (!formula.source.empty()) {
            if (std::find(cited.begin(), cited.end(), formula.source) == cited.end()) {
                cited.push_back(formula.source);
            }
            from = shownText(source(formula.source).cited_as);
            if (!formula.equation.empty()) {
                from += QLatin1Char(' ') + shownEquation(formula.equation);
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
        report.items.push_back(
            Paragraph{messageText(citation(source(key))).toHtmlEscaped(), Paragraph::Kind::Muted});
    }
    report.items.push_back(Heading{ReportWords::tr("What the model leaves out")});
    for (const Text& text : scene->left_out()) {
        report.items.push_back(Paragraph{QStringLiteral("– ") + shownText(text).toHtmlEscaped()});
    }
}

void addValidation(Report& report, const QString& scene) {
    using Model = ValidationModel;
    const auto papers = methods::papers();
    const auto paper = std::find_if(papers.begin(), papers.end(), [&](const auto& each) {
        return scene == QLatin1String(each.scene.data(), static_cast<int>(each.scene.size()));
    });
    Model model;
    model.load();
    while (model.isRunning()) {
        QApplication::processEvents(
            QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents, 20);
    }
    if (paper == papers.end() || model.report() == nullptr) {
        return;
    }
    model.setPaper(static_cast<std::size_t>(paper - papers.begin()));
    report.items.push_back(Heading{ReportWords::tr("Validation of the methods")});
    report.items.push_back(Paragraph{
        ReportWords::tr("Every number that the paper prints was compared with that of this "
                        "program, computed anew from the paper's data when this report was made: "
                        "%1. The page Methods shows each of them.")
            .arg(model.countsText())
            .toHtmlEscaped()});
    // What each place of the paper became; the page Methods has every number.
    Table table;
    table.headings = {
        model.headerData(Model::Place, Qt::Horizontal).toString().toHtmlEscaped(),
        model.headerData(Model::VerdictColumn, Qt::Horizontal).toString().toHtmlEscaped(),
        ReportWords::tr("Numbers"), ReportWords::tr("Largest difference")};
    table.numbers = {false, false, true, true};
    struct Group {
        QString place;
        QString verdict;
        int count = 0;
        double largest = -1.0;
        QString difference;
    };
    std::vector<Group> found;
    QStringList slips;
    for (int row = 0; row < model.rowCount(); ++row) {
        const auto cell = [&](int column) { return model.index(row, column).data().toString(); };
        const methods::ValidationRow& number = *model.rows()[static_cast<std::size_t>(row)];
        QString verdict = cell(Model::VerdictColumn).toHtmlEscaped();
        if (number.verdict == methods::Verdict::slip ||
            number.verdict == methods::Verdict::artefact ||
            number.verdict == methods::Verdict::differs) {
            const QString why = methodText(number.reason).toHtmlEscaped();
            if (!slips.contains(why)) {
                slips << why;
            }
            verdict += QStringLiteral(" [%1]").arg(slips.indexOf(why) + 1);
        }
        const QString place = cell(Model::Place).toHtmlEscaped();
        auto group = std::find_if(found.begin(), found.end(), [&](const Group& each) {
            return each.place == place && each.verdict == verdict;
        });
        if (group == found.end()) {
            group = found.insert(found.end(),
                                 Group{.place = place, .verdict = verdict, .difference = {}});
        }
        ++group->count;
        const auto difference = number.relative_difference();
        if (difference && std::abs(*difference) > group->largest) {
            group->largest = std::abs(*difference);
            group->difference = cell(Model::Difference).toHtmlEscaped();
        }
    }
    for (const Group& group : found) {
        table.rows << QStringList{group.place, group.verdict, QString::number(group.count),
                                  group.difference};
    }
    report.items.push_back(std::move(table));
    for (qsizetype i = 0; i < slips.size(); ++i) {
        report.items.push_back(
            Paragraph{QStringLiteral("[%1] %2").arg(i + 1).arg(slips[i]), Paragraph::Kind::Muted});
    }
}

Report makeReport(ScenePage& page, const QString& caseFile) {
    SceneModel& model = *page.model();
    model.keepTyped();
    Report report;
    report.program = QStringLiteral("Ravnoves " RAVNOVES_VERSION);
    report.date = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    report.language = currentLanguage();
    report.title = model.title().isEmpty() ? sceneTitle(model.sceneName()) : model.title();
    report.subtitle =
        ReportWords::tr("Report of a calculation: %1").arg(sceneTitle(model.sceneName()));
    std::vector<PageGroup> groups = pageParts(page);
    addCase(report, model, caseFile);
    report.items.push_back(Heading{ReportWords::tr("Inputs")});
    for (Table& table : inputTables(model)) {
        report.items.push_back(std::move(table));
    }
    addResults(report, std::move(groups));
    addTheory(report, model);
    addValidation(report, model.sceneName());
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

QString writeReport(ScenePage& page, const QString& caseFile, const QString& path) {
    if (!isReportName(path)) {
        return ReportWords::tr("%1: a report ends in .pdf or .html").arg(path);
    }
    try {
        const LightTheme light(page.window());
        const Report report = makeReport(page, caseFile);
        const QByteArray bytes = isPdf(path) ? reportAsPdf(report) : reportAsHtml(report);
        write_text_file(fsPath(path), bytes.toStdString());
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
    return {};
}

}  // namespace ravnoves
