#include "studies/exact_sum.h"

#include <cmath>

#include "case-file/input_error.h"
#include "case-file/json.h"

namespace ravnoves::studies {

namespace {

__extension__ using Wide = unsigned __int128;
constexpr std::int64_t base = std::int64_t{1} << 32;
constexpr std::int64_t most_limb = std::int64_t{1} << 61;
constexpr std::int64_t most_pending = std::int64_t{1} << 29;

}  // namespace

void ExactSum::add(double x) {
    if (x == 0.0) {
        return;
    }
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(x), &exponent);
    const auto whole = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    const int bit = exponent - 53 + offset;
    auto at = static_cast<std::size_t>(bit / 32);
    const Wide shifted = static_cast<Wide>(whole) << (bit % 32);
    const std::int64_t sign = x < 0.0 ? -1 : 1;
    for (Wide rest = shifted; rest != 0; rest >>= 32) {
        limbs_[at++] += sign * static_cast<std::int64_t>(rest & 0xffffffffU);
    }
    if (++pending_ >= most_pending) {
        carry(limbs_);
        pending_ = 0;
    }
}

void ExactSum::add(const ExactSum& other) {
    carry(limbs_);
    Limbs theirs = other.limbs_;
    carry(theirs);
    for (std::size_t i = 0; i < limbs; ++i) {
        limbs_[i] += theirs[i];
    }
    carry(limbs_);
    pending_ = 0;
}

void ExactSum::carry(Limbs& limbs) {
    for (std::size_t i = 0; i + 1 < limbs.size(); ++i) {
        const std::int64_t over = limbs[i] >> 32;  // towards −∞
        limbs[i] -= over * base;
        limbs[i + 1] += over;
    }
}

bool ExactSum::operator==(const ExactSum& other) const {
    Limbs one = limbs_;
    Limbs two = other.limbs_;
    carry(one);
    carry(two);
    return one == two;
}

double ExactSum::value() const {
    Limbs sum = limbs_;
    carry(sum);
    const bool negative = sum.back() < 0;
    if (negative) {
        for (std::int64_t& limb : sum) {
            limb = -limb;
        }
        carry(sum);
    }
    std::size_t top = sum.size();
    while (top > 0 && sum[top - 1] == 0) {
        --top;
    }
    if (top == 0) {
        return 0.0;
    }
    Wide leading = 0;  // the upper three limbs, and whether anything stands below
    bool below = false;
    for (std::size_t i = top; i-- > 0;) {
        if (i + 3 >= top) {
            leading = (leading << 32) | static_cast<Wide>(sum[i]);
        } else {
            below = below || sum[i] != 0;
        }
    }
    leading |= below ? 1 : 0;
    const auto lowest = static_cast<int>(top >= 3 ? top - 3 : 0);
    const double size = std::ldexp(static_cast<double>(leading), 32 * lowest - offset);
    return negative ? -size : size;
}

Json ExactSum::write() const {
    Limbs sum = limbs_;
    carry(sum);
    std::size_t first = 0;
    std::size_t last = sum.size();
    while (first < last && sum[first] == 0) {
        ++first;
    }
    while (last > first && sum[last - 1] == 0) {
        --last;
    }
    Json json = Json::array({first});
    for (std::size_t i = first; i < last; ++i) {
        json.push_back(sum[i]);
    }
    return json;
}

ExactSum ExactSum::read(const Json& json, const std::string& pointer) {
    ExactSum sum;
    bool good = json.is_array() && !json.empty() && json.size() <= limbs + 1;
    for (std::size_t i = 0; good && i < json.size(); ++i) {
        good = json[i].is_number_integer() && std::abs(json[i].get<std::int64_t>()) < most_limb;
    }
    const std::int64_t first = good ? json[0].get<std::int64_t>() : -1;
    good = first >= 0 && first + static_cast<std::int64_t>(json.size()) - 1 <= limbs;
    if (!good) {
        throw InputError(pointer, CORE_TEXT("studies", "is not a sum of this program"));
    }
    for (std::size_t i = 1; i < json.size(); ++i) {
        sum.limbs_[static_cast<std::size_t>(first) + i - 1] = json[i].get<std::int64_t>();
    }
    return sum;
}

}  // namespace ravnoves::studies
