#include "shop/scale_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <regex>

namespace ravnoves::shop {

namespace {

using Kind = ScaleLine::Kind;

/// Words of a line and what they say of its number: nothing of gross and net. What follows the S of
/// MT-SICS is joined to it.
struct MarkWords {
    std::optional<Kind> kind;
    std::string_view words;
};
constexpr MarkWords marks[] = {{Kind::stable, "ST HD S:S"},
                               {Kind::moving, "US SD S:D ?"},
                               {Kind::overload, "OL S:+"},
                               {Kind::underload, "UL S:-"},
                               {Kind::other, "TR T PT TARE QT ES ET EL S:I"},
                               {std::nullopt, "GS NT G N NET GROSS"}};

struct UnitWords {
    Unit unit;
    std::string_view words;  ///< Russian ones in UTF-8, CP1251 and CP866
};
constexpr UnitWords unit_words[] = {{units::gram, "G \xD0\xB3 \xE3 \xA3"},
                                    {units::kg, "KG \xD0\xBA\xD0\xB3 \xEA\xE3 \xAA\xA3"},
                                    {units::milligram, "MG"},
                                    {units::ounce, "OZ"},
                                    {units::pound, "LB LBS"}};

/// The row that has the word; null without one.
const auto* row_of(const auto& table, const std::string& word) {
    const auto spaced = [](std::string_view words) { return std::string(" ").append(words) + ' '; };
    for (const auto& row : table) {
        if (spaced(row.words).find(spaced(word)) != std::string::npos) {
            return &row;
        }
    }
    return static_cast<decltype(&table[0])>(nullptr);
}

}  // namespace

double ScaleLine::last_digit() const {
    return std::pow(10.0, -decimals) * unit;
}

ScaleLine parse_scale_line(std::string_view text, const Unit& usual) {
    // Behind blanks, and commas that are no decimal ones: S with what follows it, another word,
    // both with their comma, or a number.
    static const std::regex part(
        R"((?:[ \t]|,(?!\d))*(?:(?:S(?![A-Z\x80-\xFF])(?:[ \t]|,(?!\d))*([^ ]+)|)"
        R"(([A-Z\x80-\xFF]+|\?)),?|([+-]?) *(\d*)(?:[.,](\d+))?))");
    const auto is_margin = [](char c) { return static_cast<unsigned char>(c) <= 0x20; };
    while (!text.empty() && is_margin(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && (is_margin(text.back()) || text.back() == ',')) {
        text.remove_suffix(1);
    }
    std::string line(text);
    for (char& c : line) {
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    ScaleLine said;
    said.unit = usual;
    bool has_number = false;
    bool has_unit = false;
    std::optional<Kind> kind;  // moving counts more than stable, what is no weight more than both
    std::smatch found;
    for (auto at = line.cbegin(); at != line.cend(); at = found[0].second) {
        constexpr auto here = std::regex_constants::match_continuous;
        if (!std::regex_search(at, line.cend(), found, part, here)) {
            return said;
        }
        std::string word(found[1].matched ? "S:" : "");
        word += found[found[1].matched ? 1 : 2];
        if (found[1].matched && has_number) {
            return said;
        }
        if (word.empty() || (word == "?" && !has_number)) {
            constexpr std::ptrdiff_t max_digits = 12;
            const auto digits = found[4].length() + found[5].length();
            if (!word.empty() || has_number || digits == 0 || digits > max_digits) {
                return said;
            }
            std::string plain(found[3] == "-" ? "-" : "");
            plain.append(found[4]).append(".").append(found[5]);
            std::from_chars(plain.data(), plain.data() + plain.size(), said.number);
            said.decimals = static_cast<int>(found[5].length());
            has_number = true;
            continue;
        }
        const auto* const unit = has_number && !has_unit ? row_of(unit_words, word) : nullptr;
        if (unit != nullptr) {
            has_unit = true;
            said.unit = unit->unit;
            continue;
        }
        const auto* const mark = row_of(marks, word);
        if (mark == nullptr) {
            return said;
        }
        kind = std::max(kind, mark->kind);
        if (!has_number) {
            said.form = ScaleLine::Form::marked;
            if (kind > Kind::moving) {
                said.kind = *kind;
                return said;
            }
        }
    }
    if (!has_number) {
        return said;
    }
    if (said.form == ScaleLine::Form::number && has_unit) {
        said.form = ScaleLine::Form::number_and_unit;
    }
    const bool is_whole = said.form != ScaleLine::Form::marked || has_unit;
    said.kind = kind > Kind::stable    ? *kind
                : is_whole             ? Kind::stable
                : kind == Kind::stable ? Kind::garbled  // half a line
                                       : Kind::moving;  // Sartorius: the unit comes at rest
    return said;
}

bool ScaleLines::next(std::string& line) {
    constexpr std::string_view ends = "\r\n";
    rest_.erase(0, std::min(rest_.find_first_not_of(ends), rest_.size()));
    std::size_t end = rest_.find_first_of(ends);
    if (end == std::string::npos) {
        if (rest_.size() < longest) {
            return false;
        }
        end = rest_.size();
    }
    line = rest_.substr(0, end);
    rest_.erase(0, end);
    return true;
}

std::string ScaleLines::drop() {
    std::string dropped;
    dropped.swap(rest_);
    return dropped;
}

bool PartByPart::takes(const ScaleLine& line) {
    if (!line.has_weight()) {
        equal_ = 0;
        return false;
    }
    const double mass = line.mass();
    const double digit = line.last_digit();
    // The zero may wander by some digits, and a hand that takes the next part is quick.
    if (mass <= std::max(5.0 * digit, 0.02 * taken_)) {
        loaded_ = false;
        taken_ = 0.0;
        equal_ = 0;
        return false;
    }
    equal_ = line.kind != Kind::stable ? 0 : std::abs(mass - last_) <= 0.5 * digit ? equal_ + 1 : 1;
    last_ = mass;
    if (loaded_ || equal_ < still) {
        return false;
    }
    loaded_ = true;
    taken_ = mass;
    return true;
}

}  // namespace ravnoves::shop
