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
#include <tuple>

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

/// A number that is no larger than the size of what it is of: one of the sums, or of a spread the
/// difference of two.
struct Key {
    std::size_t at;
    std::optional<std::size_t> less;

    double operator()(const double* sum) const { return sum[at] - (less ? sum[*less] : 0.0); }
};

/// The placings of one kind; of those that add up to the same the one that moves the fewest sets.
class Placings {
  public:
    struct Each {
        std::size_t at;
        int moved;
        // Of two placings the sum of like keys is no larger than their size.
        double cell = 0.0;  ///< of the first key
        double key = 0.0;   ///< the second

        auto operator<=>(const Each& other) const {
            return std::tuple(moved, cell, key) <=> std::tuple(other.moved, other.cell, other.key);
        }
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
    void sort_by(const std::array<Key, 2>& keys, double width) {
        for (Each& each : list) {
            each.cell = std::floor(keys[0](sum(each)) / width);
            each.key = keys[1](sum(each));
        }
        std::sort(list.begin(), list.end());
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

/// The two keys by which placings differ most.
std::array<Key, 2> widest_keys(const SetSearch& search, const Placings& placings) {
    const bool is_spread = search.size == SetSearch::Size::spread;
    std::array<Key, 2> keys{{{0, 0}, {0, 0}}};
    std::array<double, 2> widths{-1.0, -1.0};
    for (std::size_t i = 0; i < search.dimensions; ++i) {
        for (std::size_t k = is_spread ? i + 1 : 0; k < (is_spread ? search.dimensions : 1); ++k) {
            const Key key{i, is_spread ? std::optional(k) : std::nullopt};
            double minimum = infinity;
            double maximum = -infinity;
            for (const Placings::Each& each : placings.list) {
                minimum = std::min(minimum, key(placings.sum(each)));
                maximum = std::max(maximum, key(placings.sum(each)));
            }
            if (maximum - minimum > widths[0]) {
                keys = {key, keys[0]};
                widths = {maximum - minimum, widths[0]};
            } else if (maximum - minimum > widths[1]) {
                keys[1] = key;
                widths[1] = maximum - minimum;
            }
        }
    }
    return keys;
}

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
    const double start = (std::max(best.size, search.enough) + 2.0 * search.rounding) * 1.001;
    const auto keys = widest_keys(search, second);
    first.sort_by(keys, start);
    second.sort_by(keys, start);
    const auto end = second.list.end();
    const auto may_help = [&](int moved) { return is_better(search, {0.0, moved}, best); };
    const auto compare = [&](const Placings::Each& a, int moved, double cell) {
        const double limit = std::max(best.size, search.enough) + 2.0 * search.rounding;
        for (auto b = std::lower_bound(second.list.begin(), end,
                                       Placings::Each{0, moved, cell, -a.key - limit});
             b != end && b->moved == moved && b->cell == cell && b->key <= limit - a.key; ++b) {
            const Rank rank{size_within(limit, first.sum(a), second.sum(*b), search),
                            a.moved + moved};
            if (is_better(search, rank, best)) {
                best = rank;
                best_from = {first.from(a), second.from(*b)};
            }
        }
    };
    for (const Placings::Each& a : first.list) {
        if (!may_help(a.moved)) {
            break;
        }
        for (int moved = 0; moved <= second.list.back().moved && may_help(a.moved + moved);
             ++moved) {
            // A cell of the first key and its neighbours hold all that may do.
            for (double cell = -a.cell - 2.0; cell <= -a.cell + 1.0; ++cell) {
                compare(a, moved, cell);
            }
        }
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
