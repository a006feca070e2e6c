#include "shop/scale_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

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

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           static_cast<unsigned char>(c) >= 0x80;
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string take(std::string_view& line, std::size_t count) {
    const std::string taken(line.substr(0, count));
    line.remove_prefix(taken.size());
    return taken;
}

/// Skips blanks and the commas between the parts. @return true where something is left
bool skip_blanks(std::string_view& line) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t' ||
                             (line.front() == ',' && !(line.size() > 1 && is_digit(line[1]))))) {
        line.remove_prefix(1);
    }
    return !line.empty();
}

/// A question mark, or letters as capitals.
std::string take_word(std::string_view& line) {
    std::size_t count = 1;
    while (is_letter(line.front()) && count < line.size() && is_letter(line[count])) {
        ++count;
    }
    std::string word = take(line, count);
    for (char& c : word) {
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return word;
}

bool take_number(std::string_view& line, ScaleLine& said) {
    std::string plain;
    if (line.front() == '+' || line.front() == '-') {
        plain = take(line, 1) == "-" ? "-" : "";
        take(line, line.find_first_not_of(' '));
    }
    int digits = 0;
    bool has_point = false;
    while (!line.empty()) {
        const char c = line.front();
        const bool is_point =
            (c == '.' || c == ',') && !has_point && line.size() > 1 && is_digit(line[1]);
        if (!is_digit(c) && !is_point) {
            break;
        }
        has_point = has_point || is_point;
        digits += is_point ? 0 : 1;
        said.decimals += !is_point && has_point ? 1 : 0;
        plain += is_point ? '.' : c;
        line.remove_prefix(1);
    }
    constexpr int max_digits = 12;
    if (digits == 0 || digits > max_digits) {
        return false;
    }
    std::from_chars(plain.data(), plain.data() + plain.size(), said.number);
    return true;
}

}  // namespace

double ScaleLine::last_digit() const {
    return std::pow(10.0, -decimals) * unit;
}

ScaleLine parse_scale_line(std::string_view line, const Unit& usual) {
    const auto is_margin = [](char c) { return static_cast<unsigned char>(c) <= 0x20; };
    while (!line.empty() && is_margin(line.front())) {
        line.remove_prefix(1);
    }
    while (!line.empty() && is_margin(line.back())) {
        line.remove_suffix(1);
    }
    ScaleLine said;
    said.unit = usual;
    bool has_number = false;
    bool has_unit = false;
    std::optional<Kind> kind;  // moving counts more than stable, what is no weight more than both
    while (skip_blanks(line)) {
        if (!is_letter(line.front()) && (line.front() != '?' || !has_number)) {
            if (has_number || !take_number(line, said)) {
                return said;
            }
            has_number = true;
            continue;
        }
        std::string word = take_word(line);
        const auto* const unit = has_number && !has_unit ? row_of(unit_words, word) : nullptr;
        if (unit != nullptr) {
            has_unit = true;
            said.unit = unit->unit;
            continue;
        }
        if (word == "S" && !has_number && skip_blanks(line)) {
            word += ":" + take(line, line.find(' '));
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
            take(line, line.starts_with(',') ? 1 : 0);
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
