#include "balance-shaft/model/import_model.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/input.h"
#include "case-file/decimal.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
#include "model/background_job.h"
#include "model/enough_memory.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/write_file.h"

namespace ravnoves {

using balance_shaft::DeadCentre;
using balance_shaft::Measured;
using balance_shaft::TableReading;

ImportModel::ImportModel(Measured what, const SliderCrank<double>& crank, int strokes,
                         QObject* parent)
    : QObject(parent),
      what_(what),
      crank_(crank),
      strokes_(strokes),
      job_(new BackgroundJob(this)) {
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        unreadable_ = why;
        look_ = {};
    });
    connect(job_, &BackgroundJob::runningChanged, this, &ImportModel::changed);
}

void ImportModel::open(const QString& path) {
    path_ = path;
    text_.reset();
    start();
}

void ImportModel::decide(const TableReading& decided) {
    decided_ = decided;
    start();
}

void ImportModel::start() {
    job_->start(
        [this, what = what_, crank = crank_, path = path_, text = text_,
         decided = decided_](const BackgroundJob::Progress& continues) -> std::function<void()> {
            return withinMemory([&]() -> std::function<void()> {
                const auto read =
                    text ? text : std::make_shared<const std::string>(read_text_file(fsPath(path)));
                auto look = std::make_shared<Look>(lookAt(*read, what, decided, crank, continues));
                return [this, read, look] {
                    text_ = read;
                    look_ = std::move(*look);
                    unreadable_.clear();
                };
            });
        });
}

ImportModel::Look ImportModel::lookAt(const std::string& text, Measured what,
                                      const TableReading& decided, const SliderCrank<double>& crank,
                                      const std::function<bool(double)>& continues) {
    constexpr std::size_t shown_rows = 12;
    Look look;
    // Settings can be changed also where no rows are found.
    const TableView view = look_at_table(text, decided.layout);
    look.proposal.reading = decided;
    look.proposal.reading.layout.separator = view.separator;
    look.proposal.reading.layout.header_lines = view.header_lines;
    look.lines = look_at_table(text, {view.separator, decided.layout.decimal_comma, 0},
                               view.header_lines + shown_rows)
                     .rows;
    look.columns = static_cast<int>(std::min(view.columns, std::size_t{max_columns}));
    if (!continues(0.1)) {
        return look;
    }
    try {
        look.proposal = propose_reading(text, what, decided);
        if (!continues(0.4)) {
            return look;
        }
        look.cycle = parse_cycle(what, text, look.proposal.reading);
        if (what == Measured::pressure) {
            look.deadCentre = find_dead_centre(crank, look.cycle->trace);
            if (continues(0.7)) {
                chooseKept(text, look);
            }
        }
    } catch (const InputError& error) {
        look.trouble = error;
        if (!look.proposal.doubts.empty()) {
            look.proposal.doubts.pop_back();  // the same
        }
    }
    return look;
}

/// As little as reads the same trace when the case is opened.
void ImportModel::chooseKept(const std::string& text, Look& look) {
    const TableReading& reading = look.proposal.reading;
    TableReading kept;
    kept.columns = reading.columns;
    kept.unit = reading.unit;
    kept.gauge = reading.gauge;
    const auto isSame = [&](TableReading tried) {
        tried.strokes = reading.strokes;  // of the case
        try {
            return parse_cycle(Measured::pressure, text, tried).trace == look.cycle->trace;
        } catch (const InputError&) {
            return false;
        }
    };
    look.sum = sha256(text);
    look.kept = isSame({}) ? TableReading{} : kept;
    look.needsOwnFile = !(look.kept == TableReading{}) && !isSame(kept);
}

std::optional<int> ImportModel::column(int which) const {
    const int number = QString::fromStdString(reading().columns.at(static_cast<std::size_t>(which)))
                           .toInt();  // all are numbers here; 0 where none is proposed
    return number > 0 ? std::optional(number - 1) : std::nullopt;
}

void ImportModel::decideColumn(int which, std::optional<int> column) {
    TableReading decided = decided_;
    decided.columns = reading().columns;
    decided.columns.at(static_cast<std::size_t>(which)) = std::to_string(column ? *column + 1 : 0);
    decide(decided);
}

QString ImportModel::heading(int column) const {
    const auto& headings = look_.proposal.headings;
    const auto place = static_cast<std::size_t>(column);
    return place < headings.size() ? QString::fromStdString(headings[place]).simplified()
                                   : QString();
}

std::optional<bool> ImportModel::decimalComma() const {
    return look_.cycle ? std::optional(look_.cycle->decimal_comma) : decided_.layout.decimal_comma;
}

bool ImportModel::asksForCycle() const {
    return look_.cycle && look_.cycle->strokes != strokes_ &&
           look_.cycle->strokes != decided_.strokes;
}

bool ImportModel::isReady() const {
    return look_.cycle && !asksForCycle() && !job_->isRunning();
}

QString ImportModel::understoodText() const {
    return look_.cycle ? messageText(look_.cycle->describe()) + QLatin1Char('.') : QString();
}

QString ImportModel::troubleText() const {
    return look_.trouble ? errorText(*look_.trouble) : unreadable_;
}

QString ImportModel::doubtsText() const {
    QStringList doubts;
    for (const Message& doubt : look_.proposal.doubts) {
        doubts << messageText(doubt);
    }
    if (asksForCycle()) {
        doubts << (strokes_ == 4
                       ? tr("The file covers 360°, but the engine of the case is a four-stroke "
                            "(720°). Import the whole cycle, or choose the cycle of 360° to make "
                            "the engine a two-stroke.")
                       : tr("The file covers 720°, but the engine of the case is a two-stroke "
                            "(360°). Choose the cycle: 720° makes the engine a four-stroke."));
    }
    if (needsOwnFile()) {
        doubts << tr(
            "The case file cannot contain these settings: the cycle is saved as a separate CSV "
            "file.");
    }
    return doubts.join(QLatin1Char('\n'));
}

QString ImportModel::deadCentreText() const {
    if (!look_.deadCentre) {
        return {};
    }
    const DeadCentre& found = *look_.deadCentre;
    const int decimals = found.uncertainty < 0.1 * degree ? 2 : 1;
    const auto degrees = [&](double angle) {
        return fixedDecimals(angle / degree, decimals, QLocale());
    };
    return (found.is_certain()
                ? tr("Dead centre: shift by %1° ± %2° (from the compression line)")
                : tr("Dead centre, uncertain: shift by %1° ± %2° (from the compression line)"))
        .arg(degrees(found.proposed_shift()), degrees(found.uncertainty));
}

bool ImportModel::isShifted() const {
    const auto& found = look_.deadCentre;
    constexpr double farOff = 10.0;  // a turn, say, to a degree
    return found && shifted_.value_or(std::abs(found->proposed_shift()) >
                                      (found->is_certain() ? 1.0 : farOff) * found->uncertainty);
}

QString ImportModel::writeOwnFile(const QString& path) {
    const std::string text = write_pressure_trace(look_.cycle->trace);
    QString why = writeFile(path, [&] { return text; });
    if (why.isEmpty()) {
        path_ = path;
        look_.cycle->trace = balance_shaft::parse_cycle(Measured::pressure, text).trace;
        look_.kept = {};
        look_.needsOwnFile = false;
        look_.sum = sha256(text);
    }
    return why;
}

void ImportModel::putTraceInto(balance_shaft::Input& input) const {
    balance_shaft::TorqueSource& torque = input.torque;
    torque.kind = balance_shaft::TorqueSource::Kind::pressure;
    torque.trace = look_.cycle->trace;
    torque.trace_file = {path_.toStdString(), look_.sum, look_.sum, look_.kept};
    constexpr int decimals = 2;  // as it is proposed
    torque.trace_shift =
        isShifted()
            ? rounded_to_decimals(look_.deadCentre->proposed_shift() / degree, decimals) * degree
            : 0.0;
    input.strokes = input.strokes_of_torque();
    balance_shaft::fill_cylinder(input);
}

}  // namespace ravnoves
