#include "shop/set_search.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>

namespace ravnoves::shop {

namespace {

using From = std::array<std::vector<int>, 2>;
using Values = std::vector<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t max_placings = 40'320;  // 8!
// Additions in the search by exchanges.
constexpr long few_exchanges = 4'000'000;
constexpr long many_exchanges = 40'000'000;

double size_of(std::span<const double> sum, SetSearch::Size size) {
    if (size == SetSearch::Size::spread) {
        const auto [minimum, maximum] = std::minmax_element(sum.begin(), sum.end());
        return sum.empty() ? 0.0 : *maximum - *minimum;
    }
    double squares = 0.0;
    for (const double each : sum) {
        squares += each * each;
    }
    return std::sqrt(squares);
}

const double* adds_of(const SetSearch& search, std::size_t kind, int set, std::size_t place) {
    return &search.kinds[kind]
                .adds[(static_cast<std::size_t>(set) * search.places + place) * search.dimensions];
}

int moved_of(const From& from) {
    int moved = 0;
    for (const auto& kind : from) {
        for (std::size_t place = 0; place < kind.size(); ++place) {
            moved += kind[place] != static_cast<int>(place) ? 1 : 0;
        }
    }
    return moved;
}

/// How good a placing is.
struct Rank {
    double size = infinity;
    int moved = std::numeric_limits<int>::max();
};

/// Compares as the search wants it; sizes that differ by rounding are the same.
bool is_better(const SetSearch& search, const Rank& rank, const Rank& best) {
    const double size = std::max(rank.size, search.enough);
    const double minimum = std::max(best.size, search.enough);
    if (std::abs(size - minimum) > search.rounding) {
        return size < minimum;
    }
    return rank.moved != best.moved ? rank.moved < best.moved
                                    : rank.size < best.size - search.rounding;
}

// ------------------------------------------------------------------------------ by exchanges

/// Looks for better placings by exchanges of two sets, within a bound of its work.
class Exchanges {
  public:
    Exchanges(const SetSearch& search, long work) : search_(search), work_(work) {
        for (std::size_t kind = 0; kind < 2; ++kind) {
            const auto& group = search.kinds[kind].group;
            for (std::size_t p = 0; p < search.places; ++p) {
                for (std::size_t q = p + 1; q < search.places; ++q) {
                    if (group[p] == group[q]) {
                        pairs_.push_back({kind, p, q});
                    }
                }
            }
        }
    }

    bool has_work() const { return work_ > 0 && !pairs_.empty(); }
    /// The best exchange, and again, as long as one helps.
    Rank improve(From& from) {
        Rank best{size_of(search_, from), moved_of(from)};
        for (bool helps = true; helps && has_work();) {
            helps = false;
            const Values sum = sum_of(search_, from);
            const int moved = moved_of(from);
            Pair step{};
            for (const Pair& pair : pairs_) {
                const Rank rank = exchanged(from, sum, moved, pair);
                if (is_better(search_, rank, best)) {
                    best = rank;
                    step = pair;
                    helps = true;
                }
            }
            if (helps) {
                std::swap(from[step.kind][step.p], from[step.kind][step.q]);
            }
        }
        return best;
    }
    void shuffle(From& from) {
        for (std::size_t kind = 0; kind < 2; ++kind) {
            const auto& group = search_.kinds[kind].group;
            for (std::size_t p = search_.places - 1; p > 0; --p) {
                const std::size_t q = random_() % (p + 1);
                if (group[p] == group[q]) {
                    std::swap(from[kind][p], from[kind][q]);
                }
            }
        }
    }

  private:
    /// Places whose sets may change.
    struct Pair {
        std::size_t kind;
        std::size_t p;
        std::size_t q;
    };
    /// How good the placing is once the sets of two places have changed.
    Rank exchanged(const From& from, const Values& sum, int moved, const Pair& pair) {
        const int one = from[pair.kind][pair.p];
        const int other = from[pair.kind][pair.q];
        const double* off_p = adds_of(search_, pair.kind, one, pair.p);
        const double* off_q = adds_of(search_, pair.kind, other, pair.q);
        const double* on_p = adds_of(search_, pair.kind, other, pair.p);
        const double* on_q = adds_of(search_, pair.kind, one, pair.q);
        sum_.resize(sum.size());
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum_[i] = sum[i] + (on_p[i] - off_p[i]) + (on_q[i] - off_q[i]);
        }
        const int p = static_cast<int>(pair.p);
        const int q = static_cast<int>(pair.q);
        work_ -= static_cast<long>(6 * sum.size());
        return {size_of(sum_, search_.size), moved - (one != p ? 1 : 0) - (other != q ? 1 : 0) +
                                                 (other != p ? 1 : 0) + (one != q ? 1 : 0)};
    }

    const SetSearch& search_;
    std::vector<Pair> pairs_;
    std::mt19937 random_{1};
    Values sum_;
    long work_;
};

// ----------------------------------------------------------------------------- all placings

std::size_t placings_of(const SetKind& kind) {
    std::size_t count = 1;
    for (auto at = kind.group.begin(); at != kind.group.end() && count <= max_placings; ++at) {
        count *= static_cast<std::size_t>(std::count(kind.group.begin(), at + 1, *at));
    }
    return count;
}

/// The placings of one kind; of those that add up to the same the one that moves the fewest sets.
class Placings {
  public:
    struct Each {
        std::size_t at;
        int moved;
    };

    Placings(const SetSearch& search, std::size_t kind)
        : search_(search),
          kind_(kind),
          from_(search.places),
          used_(search.places, false),
          partial_((search.places + 1) * search.dimensions, 0.0) {
        if (kind == 0) {
            std::copy(search.fixed.begin(), search.fixed.end(), partial_.begin());
        }
        extend(0, 0);
        keep_unlike();
    }

    std::vector<Each> list;

    const double* sum(const Each& each) const { return &sums_[each.at * search_.dimensions]; }
    std::vector<int> from(const Each& each) const {
        const auto begin = froms_.begin() + static_cast<std::ptrdiff_t>(each.at * search_.places);
        return {begin, begin + static_cast<std::ptrdiff_t>(search_.places)};
    }

  private:
    void extend(std::size_t place, int moved) {
        const std::size_t d = search_.dimensions;
        const double* before = &partial_[place * d];
        if (place == search_.places) {
            list.push_back({list.size(), moved});
            froms_.insert(froms_.end(), from_.begin(), from_.end());
            sums_.insert(sums_.end(), before, before + d);
            return;
        }
        const auto& group = search_.kinds[kind_].group;
        for (std::size_t set = 0; set < search_.places; ++set) {
            if (used_[set] || group[set] != group[place]) {
                continue;
            }
            used_[set] = true;
            from_[place] = static_cast<std::uint8_t>(set);
            const double* adds = adds_of(search_, kind_, static_cast<int>(set), place);
            std::transform(before, before + d, adds, &partial_[(place + 1) * d], std::plus());
            extend(place + 1, moved + (set != place ? 1 : 0));
            used_[set] = false;
        }
    }
    void keep_unlike() {
        const std::size_t d = search_.dimensions;
        std::vector<std::int64_t> grains;
        for (const double each : sums_) {
            grains.push_back(std::llround(each / search_.rounding));
        }
        const auto of = [&](const Each& each) { return std::span(&grains[each.at * d], d); };
        std::sort(list.begin(), list.end(), [&](const Each& a, const Each& b) {
            const auto order = std::lexicographical_compare_three_way(of(a).begin(), of(a).end(),
                                                                      of(b).begin(), of(b).end());
            return std::is_neq(order) ? std::is_lt(order) : a.moved < b.moved;
        });
        const auto are_like = [&](const Each& a, const Each& b) {
            return std::equal(of(a).begin(), of(a).end(), of(b).begin());
        };
        list.erase(std::unique(list.begin(), list.end(), are_like), list.end());
    }

    const SetSearch& search_;
    std::size_t kind_;
    std::vector<std::uint8_t> from_;
    std::vector<bool> used_;
    Values partial_;  ///< after each place
    std::vector<std::uint8_t> froms_;
    Values sums_;
};

/// Placings in boxes of their sums, each halved until few are left: what is in a box that holds
/// nothing better is passed over.
class Boxes {
  public:
    Boxes(const SetSearch& search, Placings& placings) : search_(search), placings_(placings) {
        split(0, placings.list.size());
    }

    /// Calls with each placing that may be better together with one of the other kind.
    void visit(const double* other, const auto& may_help, const auto& use,
               std::size_t at = 0) const {
        const Box& box = boxes_[at];
        if (!may_help(Rank{least_size(at, other), box.moved})) {
            return;
        }
        if (box.second == 0) {
            std::for_each(placings_.list.begin() + box.from, placings_.list.begin() + box.to, use);
            return;
        }
        visit(other, may_help, use, at + 1);
        visit(other, may_help, use, box.second);
    }

  private:
    struct Box {
        std::ptrdiff_t from;
        std::ptrdiff_t to;
        std::size_t second;  ///< of its halves, the first follows it; 0: it has none
        int moved;           ///< at least
    };

    std::size_t split(std::ptrdiff_t from, std::ptrdiff_t to) {
        const std::size_t d = search_.dimensions;
        Values low(d, infinity);
        Values high(d, -infinity);
        int moved = std::numeric_limits<int>::max();
        for (std::ptrdiff_t i = from; i < to; ++i) {
            const Placings::Each& each = placings_.list[i];
            moved = std::min(moved, each.moved);
            for (std::size_t k = 0; k < d; ++k) {
                low[k] = std::min(low[k], placings_.sum(each)[k]);
                high[k] = std::max(high[k], placings_.sum(each)[k]);
            }
        }
        const std::size_t at = boxes_.size();
        boxes_.push_back({from, to, 0, moved});
        ends_.insert(ends_.end(), low.begin(), low.end());
        ends_.insert(ends_.end(), high.begin(), high.end());
        constexpr std::ptrdiff_t few = 8;
        if (to - from > few) {
            std::transform(high.begin(), high.end(), low.begin(), low.begin(), std::minus());
            const auto widest = std::max_element(low.begin(), low.end()) - low.begin();
            const std::ptrdiff_t middle = (from + to) / 2;
            const auto begin = placings_.list.begin();
            std::nth_element(begin + from, begin + middle, begin + to,
                             [&](const Placings::Each& a, const Placings::Each& b) {
                                 return placings_.sum(a)[widest] < placings_.sum(b)[widest];
                             });
            split(from, middle);
            const std::size_t second = split(middle, to);
            boxes_[at].second = second;
        }
        return at;
    }
    /// Of anything in a box, together with another placing.
    double least_size(std::size_t at, const double* other) const {
        const double* low = &ends_[2 * search_.dimensions * at];
        const double* high = low + search_.dimensions;
        double squares = 0.0;
        double lowest = infinity;
        double highest = -infinity;
        for (std::size_t k = 0; k < search_.dimensions; ++k) {
            const double off = std::max({low[k] + other[k], -high[k] - other[k], 0.0});
            squares += off * off;
            lowest = std::min(lowest, high[k] + other[k]);
            highest = std::max(highest, low[k] + other[k]);
        }
        return search_.size == SetSearch::Size::spread ? std::max(0.0, highest - lowest)
                                                       : std::sqrt(squares);
    }

    const SetSearch& search_;
    Placings& placings_;
    std::vector<Box> boxes_;
    Values ends_;  ///< of each box the lowest sums and the highest
};

/// The size of two placings together; infinity as soon as it is known to be beyond the limit.
double size_within(double limit, const double* a, const double* b, const SetSearch& search) {
    double squares = 0.0;
    double minimum = infinity;
    double maximum = -infinity;
    for (std::size_t i = 0; i < search.dimensions; ++i) {
        const double sum = a[i] + b[i];
        squares += sum * sum;
        minimum = std::min(minimum, sum);
        maximum = std::max(maximum, sum);
        if (search.size == SetSearch::Size::spread ? maximum - minimum > limit
                                                   : squares > limit * limit) {
            return infinity;
        }
    }
    return search.size == SetSearch::Size::spread ? std::max(0.0, maximum - minimum)
                                                  : std::sqrt(squares);
}

/// Compares all placings with what is best so far.
void compare_all(const SetSearch& search, From& best_from, Rank& best) {
    Placings first(search, 0);
    Placings second(search, 1);
    std::ranges::stable_sort(first.list, {}, &Placings::Each::moved);
    const Boxes boxes(search, second);
    for (const Placings::Each& a : first.list) {
        const auto is_help = [&](Rank rank) {
            rank.moved += a.moved;
            return is_better(search, rank, best);
        };
        boxes.visit(first.sum(a), is_help, [&](const Placings::Each& b) {
            const double limit = std::max(best.size, search.enough) + 2.0 * search.rounding;
            const Rank rank{size_within(limit, first.sum(a), second.sum(b), search), b.moved};
            if (is_help(rank)) {
                best = {rank.size, a.moved + b.moved};
                best_from = {first.from(a), second.from(b)};
            }
        });
    }
}

SetsFound find_placing(const SetSearch& search) {
    const From as_it_is = unmoved_sets(search.places);
    const bool can_try_all =
        std::all_of(search.kinds.begin(), search.kinds.end(),
                    [](const SetKind& kind) { return placings_of(kind) <= max_placings; });
    From best = as_it_is;
    Exchanges exchanges(search, can_try_all ? few_exchanges : many_exchanges);
    Rank rank = exchanges.improve(best);  // the fewest move from what is fitted now
    while (exchanges.has_work()) {
        From from = as_it_is;
        exchanges.shuffle(from);
        const Rank found = exchanges.improve(from);
        if (is_better(search, found, rank)) {
            rank = found;
            best = from;
        }
    }
    if (can_try_all) {
        compare_all(search, best, rank);
    }
    // Nothing is better than to leave all where that is enough.
    const bool stays = rank.moved == 0 && rank.size <= search.enough + search.rounding;
    return {best, can_try_all || stays, rank.moved};
}

}  // namespace

From unmoved_sets(std::size_t places) {
    std::vector<int> each(places);
    std::iota(each.begin(), each.end(), 0);
    return {each, each};
}

std::vector<double> sum_of(const SetSearch& search, const std::array<std::vector<int>, 2>& from) {
    Values sum = search.fixed;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        for (std::size_t place = 0; place < search.places; ++place) {
            const double* adds = adds_of(search, kind, from[kind][place], place);
            for (std::size_t i = 0; i < search.dimensions; ++i) {
                sum[i] += adds[i];
            }
        }
    }
    return sum;
}

double size_of(const SetSearch& search, const std::array<std::vector<int>, 2>& from) {
    return size_of(sum_of(search, from), search.size);
}

SetsFound best_placing(const SetSearch& search) {
    struct Kept {
        SetSearch search;
        SetsFound found;
    };
    thread_local std::optional<Kept> kept;
    if (!kept || !(kept->search == search)) {
        kept = {search, find_placing(search)};
    }
    return kept->found;
}

}  // namespace ravnoves::shop
