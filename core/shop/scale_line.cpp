#include "shop/scale_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace ravnoves::shop {

namespace {

using Kind = ScaleLine::Kind;

/// What a word of a line says of its number; nothing for gross and net.
struct MarkWord {
    std::string_view word;
    std::optional<Kind> kind{};
};
constexpr MarkWord mark_words[] = {{"ST", Kind::stable},
                                   {"HD", Kind::stable},
                                   {"US", Kind::moving},
                                   {"SD", Kind::moving},
                                   {"OL", Kind::overload},
                                   {"UL", Kind::underload},
                                   {"GS"},
                                   {"NT"},
                                   {"G"},
                                   {"N"},
                                   {"NET"},
                                   {"GROSS"},
                                   {"TR", Kind::other},
                                   {"T", Kind::other},
                                   {"PT", Kind::other},
                                   {"TARE", Kind::other},
                                   {"QT", Kind::other},
                                   {"ES", Kind::other},
                                   {"ET", Kind::other},
                                   {"EL", Kind::other}};

struct UnitWord {
    std::string_view word;
    Unit unit;
};
constexpr UnitWord unit_words[] = {{"G", units::gram},
                                   {"KG", units::kg},
                                   {"MG", units::milligram},
                                   {"OZ", units::ounce},
                                   {"LB", units::pound},
                                   {"LBS", units::pound},
                                   {"\xD0\xB3", units::gram},        // г in UTF-8
                                   {"\xD0\xBA\xD0\xB3", units::kg},  // кг
                                   {"\xE3", units::gram},            // in CP1251
                                   {"\xEA\xE3", units::kg},
                                   {"\xA3", units::gram},  // in CP866
                                   {"\xAA\xA3", units::kg}};

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           static_cast<unsigned char>(c) >= 0x80;
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// A line while it is read, from the left.
class LineReader {
  public:
    LineReader(std::string_view line, const Unit& usual) : line_(line) { said_.unit = usual; }

    ScaleLine read() {
        said_.kind = understood() ? kind() : Kind::garbled;
        return said_;
    }

  private:
    /// @return false for what is garbled
    bool understood() {
        while (skip_blanks() && is_letter(line_.front())) {
            if (!take_mark(word())) {
                return false;
            }
            said_.form = ScaleLine::Form::marked;
            if (end_) {
                return true;
            }
            if (!line_.empty() && line_.front() == ',') {
                line_.remove_prefix(1);
            }
        }
        if (!take_number()) {
            return false;
        }
        while (skip_blanks()) {
            if (line_.front() == '?') {
                line_.remove_prefix(1);
                moving_ = true;
            } else if (!is_letter(line_.front()) || !take_trailing(word())) {
                return false;
            }
        }
        return true;
    }

    Kind kind() const {
        const bool says_unit = said_.form != ScaleLine::Form::marked || has_unit_;
        return end_        ? *end_
               : moving_   ? Kind::moving
               : says_unit ? Kind::stable
               : stable_   ? Kind::garbled  // half a line
                           : Kind::moving;    // Sartorius: the unit comes at rest
    }

    /// Skips blanks and the commas between the parts. @return true where something is left
    bool skip_blanks() {
        while (!line_.empty() &&
               (line_.front() == ' ' || line_.front() == '\t' ||
                (line_.front() == ',' && !(line_.size() > 1 && is_digit(line_[1]))))) {
            line_.remove_prefix(1);
        }
        return !line_.empty();
    }

    std::string word() {
        std::string taken;
        while (!line_.empty() && is_letter(line_.front())) {
            const char c = line_.front();
            taken += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
            line_.remove_prefix(1);
        }
        return taken;
    }

    bool take_mark(const std::string& word) {
        if (word == "S") {
            return take_sics();
        }
        const auto* const found =
            std::find_if(std::begin(mark_words), std::end(mark_words),
                         [&](const MarkWord& each) { return each.word == word; });
        if (found == std::end(mark_words)) {
            return false;
        }
        stable_ = stable_ || found->kind == Kind::stable;
        moving_ = moving_ || found->kind == Kind::moving;
        if (found->kind && found->kind != Kind::stable && found->kind != Kind::moving) {
            end_ = found->kind;
        }
        return true;
    }

    /// What follows the S of MT-SICS.
    bool take_sics() {
        if (!skip_blanks()) {
            return false;
        }
        const char status = line_.front();
        line_.remove_prefix(1);
        const bool alone = line_.find_first_not_of(' ') == std::string_view::npos;
        if (alone) {
            end_ = status == '+' ? Kind::overload : status == '-' ? Kind::underload : Kind::other;
            return status == '+' || status == '-' || status == 'I';
        }
        stable_ = status == 'S';
        moving_ = status == 'D';
        return (stable_ || moving_) && line_.front() == ' ';
    }

    bool take_number() {
        std::string plain;
        if (!line_.empty() && (line_.front() == '+' || line_.front() == '-')) {
            plain = line_.front() == '-' ? "-" : "";
            line_.remove_prefix(1);
            line_.remove_prefix(std::min(line_.find_first_not_of(' '), line_.size()));
        }
        int digits = 0;
        bool has_point = false;
        while (!line_.empty()) {
            const char c = line_.front();
            const bool is_point =
                (c == '.' || c == ',') && !has_point && line_.size() > 1 && is_digit(line_[1]);
            if (!is_digit(c) && !is_point) {
                break;
            }
            has_point = has_point || is_point;
            digits += is_point ? 0 : 1;
            said_.decimals += !is_point && has_point ? 1 : 0;
            plain += is_point ? '.' : c;
            line_.remove_prefix(1);
        }
        constexpr int max_digits = 12;
        if (digits == 0 || digits > max_digits) {
            return false;
        }
        std::from_chars(plain.data(), plain.data() + plain.size(), said_.number);
        return true;
    }

    bool take_trailing(const std::string& word) {
        if (!has_unit_) {
            for (const UnitWord& each : unit_words) {
                if (each.word == word) {
                    said_.unit = each.unit;
                    has_unit_ = true;
                    if (said_.form == ScaleLine::Form::number) {
                        said_.form = ScaleLine::Form::number_and_unit;
                    }
                    return true;
                }
            }
        }
        return word != "S" && take_mark(word);
    }

    std::string_view line_;
    ScaleLine said_;
    std::optional<Kind> end_;  ///< the line says all that it has to say
    bool stable_ = false;
    bool moving_ = false;
    bool has_unit_ = false;
};

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
    return LineReader(line, usual).read();
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
