#include "shell/variant_table.h"

#include <QDialogButtonBox>
#include <QHash>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/scene_model.h"
#include "model/variant_files.h"
#include "model/variant_results.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "shell/scene_list.h"
#include "text/shown_units.h"
#include "text/write_file.h"
#include "widgets/dialog_size.h"
#include "widgets/form_section.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

/// One number of a page's results, by what names it: its row, in a table of several columns the
/// heading too.
using Figures = QList<std::pair<QString, QString>>;

/// As units have none; exponents are others.
bool hasNoDigit(const QString& text) {
    return std::none_of(text.begin(), text.end(), [](QChar each) { return each.isDigit(); });
}

bool isNumberAlone(const QString& text) {
    return !hasNoDigit(text) && std::none_of(text.begin(), text.end(), [](QChar each) {
        return each.isLetter() || each == QLatin1Char('%');
    });
}

/// @param text  tables as ScenePage::resultsAsText() has them, each behind an empty line; sentences
///              between them are left out
Figures figuresOf(const QString& text) {
    Figures figures;
    QStringList headings;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        const QStringList cells = line.split(QLatin1Char('\t'));
        if (cells.size() < 2) {
            headings.clear();
        } else if (headings.isEmpty()) {
            headings = cells;
        } else if (cells.size() == 2) {
            figures << std::pair(cells[0], cells[1]);
        } else if (cells.size() == 3 && hasNoDigit(cells[2])) {
            figures << std::pair(
                cells[2].isEmpty() ? cells[0] : cells[0] + QStringLiteral(", ") + cells[2],
                cells[1]);
        } else {
            // A unit over the names is that of all numbers that have none of their own.
            const QString unit = unitOfTitle(headings[0]) == headings[0] ? headings[0] : QString();
            for (qsizetype i = 1; i < cells.size(); ++i) {
                const QString name = cells[0] + QStringLiteral(" · ") + headings.value(i);
                figures << std::pair(isNumberAlone(cells[i]) ? titleWithUnit(name, unit) : name,
                                     cells[i]);
            }
        }
    }
    return figures;
}

}  // namespace

VariantTable::VariantTable(ScenePage* page, QWidget* parent)
    : QDialog(parent), page_(page), words_(captionLabel({}, this)), table_(new ResultTable(this)) {
    setWindowTitle(tr("Variants side by side"));
    resizeWithText(this, 720, 520);
    for (const SceneInfo& info : sceneList()) {
        if (page->model()->parts().empty() && info.name == page->model()->sceneName()) {
            twin_.reset(info.make(nullptr));
        }
    }
    auto* column = new QVBoxLayout(this);
    table_->setAccessibleName(windowTitle());
    constexpr int fewest = 8;
    table_->setShownRows(fewest);
    column->addWidget(table_, 1);
    colourText(words_, &Theme::warning);
    column->addWidget(words_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    table_->addCopyButtons(buttons);
    QPushButton* save = buttons->addButton(tr("&Save as CSV…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &VariantTable::saveWithDialog);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    column->addWidget(buttons);
    constexpr int restMs = 300;  // every variant is solved anew: not at each step of a slider
    rest_.setSingleShot(true);
    rest_.setInterval(restMs);
    connect(&rest_, &QTimer::timeout, this, &VariantTable::showVariants);
    connect(page->model(), &SceneModel::changed, &rest_, qOverload<>(&QTimer::start));
    connect(page->model(), &SceneModel::variantsChanged, &rest_, qOverload<>(&QTimer::start));
    connect(page, &QObject::destroyed, this, [this] {
        rest_.stop();
        page_ = nullptr;
        close();
    });
    showVariants();
}

VariantTable::~VariantTable() = default;

void VariantTable::showVariants() {
    if (page_ == nullptr) {
        return;  // the page is gone, and this closes
    }
    const SceneModel& model = *page_->model();
    if (!model.parts().empty()) {
        QStringList troubles;
        table_->setResults(variantResults(model, troubles));
        sayOrHide(words_,
                  model.variants().isEmpty() ? noneText() : troubles.join(QLatin1Char('\n')));
        return;
    }
    ResultColumns columns{tr("Result")};
    QStringList troubles;
    QStringList names;
    QList<QHash<QString, QString>> values;
    const auto add = [&](const QString& title, const Json& input, const QString& trouble) {
        columns << title;
        values.emplace_back();
        if (!trouble.isEmpty()) {
            troubles << title + QStringLiteral(": ") + trouble;
            return;
        }
        twin_->model()->loadCase(input, model.context(), title);
        twin_->model()->takeView(model);
        for (const auto& [name, value] : figuresOf(twin_->resultsAsText())) {
            if (!names.contains(name)) {
                names << name;
            }
            values.last().insert(name, value);
        }
    };
    add(tr("Present"), model.inputJson(), {});
    for (int i = 0; i < model.variants().size(); ++i) {
        const QString trouble = model.variantTrouble(i);
        add(model.variants().at(i).name, trouble.isEmpty() ? model.variantInput(i) : Json(),
            trouble);
        const QString changed = trouble.isEmpty() ? changedFilesText(model, i) : QString();
        if (!changed.isEmpty()) {
            troubles << model.variants().at(i).name + QStringLiteral(": ") + changed;
        }
    }
    ResultRows rows;
    for (const QString& name : names) {
        ResultRow row{name};
        for (const auto& each : values) {
            row << ResultCell(each.value(name, QStringLiteral("–")));
        }
        rows << row;
    }
    table_->setResults({columns, rows});
    sayOrHide(words_, model.variants().isEmpty() ? noneText() : troubles.join(QLatin1Char('\n')));
}

QString VariantTable::noneText() {
    return tr("No variant is kept yet: Ctrl+K keeps the present input as one.");
}

QString VariantTable::exportTo(const QString& path) const {
    return writeFile(path, [this] { return table_->asCsv().toStdString(); });
}

void VariantTable::saveWithDialog() {
    const QString path =
        askSavePath(this, windowTitle(), QStringLiteral("variants.csv"), {csvFormat()});
    const QString trouble = path.isEmpty() ? QString() : exportTo(path);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(this, windowTitle(), trouble);
    }
}

}  // namespace ravnoves
