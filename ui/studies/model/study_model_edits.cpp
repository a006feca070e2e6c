// How a study is changed: tolerances as they are typed, watched results and their limits, method.

#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/scene_model.h"
#include "studies/model/study_model.h"
#include "text/number_text.h"
#include "text/typed_number.h"

namespace ravnoves {

using studies::Study;
using studies::Varied;
using studies::Watched;

namespace {

/// A number in the unit that is shown, and back again.
QString writtenShown(double value, double factor) {
    constexpr int converted = 6;  // digits
    return trueMinus(factor == 1.0 ? writtenOut(value, QLocale())
                                   : writtenOut(factor * value, QLocale(), converted));
}

/// @return the number in the unit of its key; none with a reason, or where there is no number
std::pair<std::optional<double>, QString> readShown(const QString& text, const ShownUnit& unit) {
    constexpr int digits = 12;
    const auto [number, trouble] = readTypedNumber(text, unit.name);
    if (!number || !trouble.isEmpty()) {
        return {std::nullopt, trouble};
    }
    return {unit.factor == 1.0 ? *number : rounded_to_digits(*number / unit.factor, digits), {}};
}

}  // namespace

double StudyModel::Input::half() const {
    const studies::Law law = varied ? studies::law_of(*varied, value) : studies::Law();
    return 0.5 * (law.high - law.low);
}

QString StudyModel::scatterText(const Input& input) {
    const std::optional<Varied>& varied = input.varied;
    if (!varied) {
        return {};
    }
    const auto written = [&](double value) { return writtenShown(value, input.shown.factor); };
    switch (varied->spread) {
        case Varied::Spread::plus_minus:
            return written(varied->size);
        case Varied::Spread::plus_minus_percent:
            return writtenOut(varied->size, QLocale()) + QStringLiteral(" %");
        case Varied::Spread::normal:
            return QStringLiteral("σ ") + written(varied->size);
        case Varied::Spread::uniform:
            return written(varied->from) + QStringLiteral(" … ") + written(varied->to);
        case Varied::Spread::grid:
            break;  // such a study is not shown
    }
    return {};
}

QString StudyModel::readScatter(Study& next, const std::string& pointer,
                                const QString& text) const {
    const auto there = std::ranges::find(next.vary, pointer, &Varied::pointer);
    QString rest = text.trimmed();
    if (rest.isEmpty()) {
        if (there != next.vary.end()) {
            next.vary.erase(there);
        }
        return {};
    }
    const Input* input = known(pointer);
    if (input != nullptr && rest == scatterText(*input)) {
        return {};  // it represents all digits
    }
    Varied varied{.pointer = pointer};
    if (rest.endsWith(QLatin1Char('%'))) {
        varied.spread = Varied::Spread::plus_minus_percent;
        rest.chop(1);
    } else if (rest.startsWith(QChar(0x03C3)) ||
               rest.startsWith(QLatin1Char('s'), Qt::CaseInsensitive)) {
        varied.spread = Varied::Spread::normal;
        rest.remove(0, 1);
    }
    if (rest.startsWith(QChar(0x00B1))) {
        rest.remove(0, 1);
    }
    rest = rest.trimmed();
    const ShownUnit unit = varied.spread == Varied::Spread::plus_minus_percent || input == nullptr
                               ? ShownUnit()
                               : input->shown;
    const auto [number, trouble] = readShown(rest, unit);
    if (!number || !(*number > 0.0)) {
        return !trouble.isEmpty() ? trouble
                                  : tr("“%1” is not a tolerance. Examples: 0.02, 1 %, σ 0.01.")
                                        .arg(text.trimmed());
    }
    varied.size = *number;
    (there != next.vary.end() ? *there : next.vary.emplace_back()) = varied;
    return {};
}

void StudyModel::take(Preset preset) {
    Study next = study_;
    const bool isPercent = preset == Preset::OnePercent;
    for (const Input& input : inputs_) {
        const bool isLength = input.unit == unitText("mm");
        const double size = isPercent                             ? 1.0
                            : input.unit.endsWith(unitText("kg")) ? weighedGrams / 1000.0
                            : input.unit == unitText("g")         ? weighedGrams
                            : isLength                            ? machinedMm
                                                                  : 0.0;
        // Half of the samples of no mass would be negative.
        const bool isNone = input.value == 0.0 && (isPercent || !isLength);
        if (input.isMissing || size == 0.0 || isNone) {
            continue;
        }
        Varied varied{.pointer = input.pointer, .size = size};
        if (isPercent) {
            varied.spread = Varied::Spread::plus_minus_percent;
        }
        std::erase_if(next.vary, [&](const Varied& each) { return each.pointer == input.pointer; });
        next.vary.push_back(varied);
    }
    change(tr("Tolerances"), next);
}

void StudyModel::clear() {
    scene_->changeStudy(tr("Tolerances"), {});
}

void StudyModel::watch(const std::string& pointer) {
    Study next = study_;
    if (std::ranges::find(next.watch, pointer, &Watched::pointer) == next.watch.end()) {
        next.watch.push_back({pointer});
        change(tr("Watch a result"), next);
    }
}

QString StudyModel::limitText(const std::string& pointer,
                              const std::optional<double>& limit) const {
    return limit ? writtenShown(*limit, resultName(pointer).shown().factor) : QString();
}

QString StudyModel::readLimit(const std::string& pointer, const QString& text,
                              std::optional<double>& limit) const {
    const QString typed = text.trimmed();
    if (typed == limitText(pointer, limit)) {
        return {};  // it represents all digits of the limit
    }
    const auto [number, trouble] = readShown(typed, resultName(pointer).shown());
    if (!typed.isEmpty() && !number) {
        return !trouble.isEmpty()
                   ? trouble
                   : tr("%1 is not a limit: enter a number, or leave it blank.").arg(typed);
    }
    limit = number;
    return {};
}

void StudyModel::setMethod(studies::Method method) {
    Study next = study_;
    next.method = method;
    change(tr("Method"), next);
}

void StudyModel::setSamples(std::uint64_t samples) {
    Study next = study_;
    next.samples = samples;
    change(tr("Samples"), next);
}

QString StudyModel::change(const QString& name, const Study& next) {
    if (isRejected_) {
        return trouble_;  // nothing replaces what was not understood
    }
    for (const Watched& limits : next.watch) {
        if (limits.min && limits.max && *limits.min > *limits.max) {
            const double period = resultName(limits.pointer).period;
            if (period == 0.0) {
                return tr("The lower limit is above the upper limit.");
            }
            const double across =
                *limits.max + period * std::ceil((*limits.min - *limits.max) / period);
            return tr("The lower limit is above the upper limit: across 0° enter %1 instead of %2.")
                .arg(formNumber(across, QLocale()), formNumber(*limits.max, QLocale()));
        }
    }
    if (next != study_) {
        const bool isEmpty = next.vary.empty() && next.watch.empty();
        scene_->changeStudy(name, isEmpty ? std::string() : studies::write_study(next).dump());
    }
    return {};
}

}  // namespace ravnoves
