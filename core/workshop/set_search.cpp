#include "workshop/set_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>

namespace ravnoves::workshop {

namespace {

using From = std::array<std::vector<int>, 2>;
using Values = std::vector<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_placings = 40'320;  // 8!
constexpr std::size_t leaf_size = 8;
constexpr long exchange_work = 6'000'000;  // additions in the search by exchanges
constexpr long proof_work = 40'000'000;    // boxes and points compared in the proof

double size_of(std::span<const double> sum, SetSearch::Size size) {
    if (size == SetSearch::Size::spread) {
        const auto [least, most] = std::minmax_element(sum.begin(), sum.end());
        return sum.empty() ? 0.0 : *most - *least;
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
class Order {
  public:
    explicit Order(const SetSearch& search) : enough_(search.enough), rounding_(search.rounding) {}

    double rounding() const { return rounding_; }
    /// Whether something no larger and with no more moves than `rank` could be better than `best`.
    bool is_better(const Rank& rank, const Rank& best) const {
        const double size = std::max(rank.size, enough_);
        const double least = std::max(best.size, enough_);
        if (std::abs(size - least) > rounding_) {
            return size < least;
        }
        return rank.moved != best.moved ? rank.moved < best.moved
                                        : rank.size < best.size - rounding_;
    }

  private:
    double enough_;
    double rounding_;
};

// ------------------------------------------------------------------------------ by exchanges

/// Exchanges two sets as long as that helps.
void improve(const SetSearch& search, const Order& order, From& from, Rank& rank, long& work) {
    const std::size_t n = search.places;
    Values sum = sum_of(search, from);
    Values trial(sum.size());
    bool helped = true;
    while (helped && work > 0) {
        helped = false;
        for (std::size_t kind = 0; kind < 2; ++kind) {
            auto& sets = from[kind];
            const auto& group = search.kinds[kind].group;
            for (std::size_t p = 0; p < n; ++p) {
                for (std::size_t q = p + 1; q < n && work > 0; ++q) {
                    if (group[p] != group[q]) {
                        continue;
                    }
                    const double* off_p = adds_of(search, kind, sets[p], p);
                    const double* off_q = adds_of(search, kind, sets[q], q);
                    const double* on_p = adds_of(search, kind, sets[q], p);
                    const double* on_q = adds_of(search, kind, sets[p], q);
                    for (std::size_t i = 0; i < sum.size(); ++i) {
                        trial[i] = sum[i] + (on_p[i] - off_p[i]) + (on_q[i] - off_q[i]);
                    }
                    work -= static_cast<long>(4 * sum.size() + 8);
                    const int moved = rank.moved - (sets[p] != static_cast<int>(p) ? 1 : 0) -
                                      (sets[q] != static_cast<int>(q) ? 1 : 0) +
                                      (sets[q] != static_cast<int>(p) ? 1 : 0) +
                                      (sets[p] != static_cast<int>(q) ? 1 : 0);
                    const Rank found{size_of(trial, search.size), moved};
                    if (order.is_better(found, rank)) {
                        std::swap(sets[p], sets[q]);
                        sum.swap(trial);
                        rank = found;
                        helped = true;
                    }
                }
            }
        }
    }
}

void shuffle(const SetSearch& search, From& from, std::mt19937& random) {
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const auto& group = search.kinds[kind].group;
        for (std::size_t p = search.places - 1; p > 0; --p) {
            const std::size_t q = random() % (p + 1);
            if (group[p] == group[q]) {
                std::swap(from[kind][p], from[kind][q]);
            }
        }
    }
}

// ----------------------------------------------------------------------------------- proof

/// The placings of one kind: what each adds up to, and how many sets move.
struct Placings {
    std::vector<std::uint8_t> from;  ///< placing after placing
    Values sums;
    std::vector<int> moved;

    std::size_t count() const { return moved.size(); }
};

std::size_t placings_of(const SetKind& kind) {
    std::size_t count = 1;
    for (std::size_t p = 0; p < kind.group.size() && count <= most_placings; ++p) {
        count *= static_cast<std::size_t>(
            std::count(kind.group.begin(), kind.group.begin() + static_cast<std::ptrdiff_t>(p) + 1,
                       kind.group[p]));
    }
    return count;
}

class Enumeration {
  public:
    Enumeration(const SetSearch& search, std::size_t kind)
        : search_(search),
          kind_(kind),
          from_(search.places),
          used_(search.places, false),
          sums_((search.places + 1) * search.dimensions, 0.0) {
        if (kind == 0) {
            std::copy(search.fixed.begin(), search.fixed.end(), sums_.begin());
        }
        extend(0, 0);
    }

    Placings placings;

  private:
    void extend(std::size_t place, int moved) {
        const std::size_t d = search_.dimensions;
        if (place == search_.places) {
            placings.from.insert(placings.from.end(), from_.begin(), from_.end());
            const auto* sum = &sums_[place * d];
            placings.sums.insert(placings.sums.end(), sum, sum + d);
            placings.moved.push_back(moved);
            return;
        }
        const auto& group = search_.kinds[kind_].group;
        for (std::size_t set = 0; set < search_.places; ++set) {
            if (used_[set] || group[set] != group[place] || is_worse_twin(set, place)) {
                continue;
            }
            used_[set] = true;
            from_[place] = static_cast<std::uint8_t>(set);
            const double* adds = adds_of(search_, kind_, static_cast<int>(set), place);
            for (std::size_t i = 0; i < d; ++i) {
                sums_[(place + 1) * d + i] = sums_[place * d + i] + adds[i];
            }
            extend(place + 1, moved + (set != place ? 1 : 0));
            used_[set] = false;
        }
    }
    /// Whether the set is better where the set in the twin of its place is, and the other way
    /// round: both add the same, and fewer move.
    bool is_worse_twin(std::size_t set, std::size_t place) const {
        const int twin = search_.twin.empty() ? -1 : search_.twin[place];
        const auto& group = search_.kinds[kind_].group;
        if (twin < 0 || group[static_cast<std::size_t>(twin)] != group[place]) {
            return false;
        }
        const auto before = static_cast<std::size_t>(twin);
        const std::size_t other = from_[before];
        const int moved = (set != place ? 1 : 0) + (other != before ? 1 : 0);
        const int exchanged = (set != before ? 1 : 0) + (other != place ? 1 : 0);
        return exchanged != moved ? exchanged < moved : set < other;
    }

    const SetSearch& search_;
    std::size_t kind_;
    std::vector<std::uint8_t> from_;
    std::vector<bool> used_;
    Values sums_;  ///< after each place
};

/// Points in boxes within boxes.
class BoxTree {
  public:
    struct Node {
        std::size_t begin;  ///< in `points`
        std::size_t end;
        int moved;             ///< the fewest
        std::size_t left = 0;  ///< 0: a leaf
        std::size_t right = 0;
        double width = 0.0;
    };

    BoxTree(const Placings& placings, std::size_t dimensions, double rounding)
        : placings_(placings), d_(dimensions), rounding_(rounding), points(placings.count()) {
        std::iota(points.begin(), points.end(), std::size_t{0});
        build(0, points.size());
    }

    const double* low(std::size_t node) const { return &boxes_[2 * node * d_]; }
    const double* high(std::size_t node) const { return &boxes_[(2 * node + 1) * d_]; }
    const double* sum(std::size_t point) const { return &placings_.sums[point * d_]; }
    int moved(std::size_t point) const { return placings_.moved[point]; }

  private:
    const Placings& placings_;
    std::size_t d_;
    double rounding_;

  public:
    std::vector<std::size_t> points;
    std::vector<Node> nodes;

  private:
    std::size_t build(std::size_t begin, std::size_t end) {
        const std::size_t node = nodes.size();
        nodes.push_back({begin, end, std::numeric_limits<int>::max()});
        boxes_.resize(boxes_.size() + d_, infinity);
        boxes_.resize(boxes_.size() + d_, -infinity);
        double* lows = &boxes_[2 * node * d_];
        double* highs = lows + d_;
        std::size_t fewest = begin;
        for (std::size_t k = begin; k < end; ++k) {
            const double* at = sum(points[k]);
            for (std::size_t i = 0; i < d_; ++i) {
                lows[i] = std::min(lows[i], at[i]);
                highs[i] = std::max(highs[i], at[i]);
            }
            fewest = moved(points[k]) < moved(points[fewest]) ? k : fewest;
        }
        nodes[node].moved = moved(points[fewest]);
        std::size_t widest = 0;
        for (std::size_t i = 1; i < d_; ++i) {
            widest = highs[i] - lows[i] > highs[widest] - lows[widest] ? i : widest;
        }
        nodes[node].width = highs[widest] - lows[widest];
        if (nodes[node].width <= rounding_) {  // all alike: one stands for them
            std::swap(points[begin], points[fewest]);
            nodes[node].end = begin + 1;
            return node;
        }
        if (end - begin <= leaf_size) {
            return node;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [this](std::size_t k) {
            return points.begin() + static_cast<std::ptrdiff_t>(k);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
            return sum(a)[widest] < sum(b)[widest];
        });
        const std::size_t left = build(begin, middle);
        const std::size_t right = build(middle, end);
        nodes[node].left = left;
        nodes[node].right = right;
        return node;
    }

    Values boxes_;  ///< of each node its low corner, then its high one
};

/// Compares the boxes of two trees.
class Proof {
  public:
    Proof(const SetSearch& search, const Order& order, const BoxTree& a, const BoxTree& b,
          Rank best)
        : best(best), search_(search), order_(order), a_(a), b_(b), sum_(search.dimensions) {
        open(0, 0, bound(0, 0));
    }

    Rank best;
    std::optional<std::array<std::size_t, 2>> found;  ///< the points
    double least = infinity;                          ///< of what was not opened

  private:
    Rank bound(std::size_t i, std::size_t k) {
        --work_;
        const double* low_a = a_.low(i);
        const double* high_a = a_.high(i);
        const double* low_b = b_.low(k);
        const double* high_b = b_.high(k);
        const int moved = a_.nodes[i].moved + b_.nodes[k].moved;
        if (search_.size == SetSearch::Size::spread) {
            double low = -infinity;
            double high = infinity;
            for (std::size_t j = 0; j < search_.dimensions; ++j) {
                low = std::max(low, low_a[j] + low_b[j]);
                high = std::min(high, high_a[j] + high_b[j]);
            }
            return {std::max(0.0, low - high), moved};
        }
        double squares = 0.0;
        for (std::size_t j = 0; j < search_.dimensions; ++j) {
            const double away = std::max({0.0, low_a[j] + low_b[j], -(high_a[j] + high_b[j])});
            squares += away * away;
        }
        return {std::sqrt(squares), moved};
    }

    void open(std::size_t i, std::size_t k, const Rank& least_of) {
        if (!order_.is_better(least_of, best)) {
            return;
        }
        if (work_ <= 0) {
            least = std::min(least, least_of.size);
            return;
        }
        const BoxTree::Node& a = a_.nodes[i];
        const BoxTree::Node& b = b_.nodes[k];
        if (a.left == 0 && b.left == 0) {
            compare(a, b);
            return;
        }
        const bool split_a = a.left != 0 && (b.left == 0 || a.width >= b.width);
        std::array<std::array<std::size_t, 2>, 2> pairs =
            split_a ? std::array<std::array<std::size_t, 2>, 2>{{{a.left, k}, {a.right, k}}}
                    : std::array<std::array<std::size_t, 2>, 2>{{{i, b.left}, {i, b.right}}};
        std::array<Rank, 2> bounds{bound(pairs[0][0], pairs[0][1]),
                                   bound(pairs[1][0], pairs[1][1])};
        if (order_.is_better(bounds[1], bounds[0])) {
            std::swap(pairs[0], pairs[1]);
            std::swap(bounds[0], bounds[1]);
        }
        open(pairs[0][0], pairs[0][1], bounds[0]);
        open(pairs[1][0], pairs[1][1], bounds[1]);
    }

    void compare(const BoxTree::Node& a, const BoxTree::Node& b) {
        for (std::size_t i = a.begin; i < a.end; ++i) {
            const double* one = a_.sum(a_.points[i]);
            for (std::size_t k = b.begin; k < b.end; ++k) {
                --work_;
                const double* other = b_.sum(b_.points[k]);
                for (std::size_t j = 0; j < sum_.size(); ++j) {
                    sum_[j] = one[j] + other[j];
                }
                const Rank rank{size_of(sum_, search_.size),
                                a_.moved(a_.points[i]) + b_.moved(b_.points[k])};
                if (order_.is_better(rank, best)) {
                    best = rank;
                    found = {a_.points[i], b_.points[k]};
                }
            }
        }
    }

    const SetSearch& search_;
    const Order& order_;
    const BoxTree& a_;
    const BoxTree& b_;
    Values sum_;
    long work_ = proof_work;
};

}  // namespace

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

namespace {

SetsFound find_placing(const SetSearch& search) {
    const Order order(search);
    From as_it_is;
    for (auto& kind : as_it_is) {
        kind.resize(search.places);
        std::iota(kind.begin(), kind.end(), 0);
    }
    const bool provable =
        std::all_of(search.kinds.begin(), search.kinds.end(),
                    [](const SetKind& kind) { return placings_of(kind) <= most_placings; });
    SetsFound best{as_it_is, 0.0, 0.0, false, 0};
    Rank rank{size_of(search, as_it_is), 0};
    std::mt19937 random(1);
    long work = exchange_work;
    const int starts = provable ? 3 : 200;
    for (int start = 0; start < starts && work > 0; ++start) {
        From from = as_it_is;
        if (start > 0) {
            shuffle(search, from, random);
        }
        Rank found{size_of(search, from), moved_of(from)};
        improve(search, order, from, found, work);
        if (order.is_better(found, rank)) {
            rank = found;
            best.from = from;
        }
    }
    if (provable) {
        const Enumeration pistons(search, 0);
        const Enumeration rods(search, 1);
        const BoxTree a(pistons.placings, search.dimensions, order.rounding());
        const BoxTree b(rods.placings, search.dimensions, order.rounding());
        const Proof proof(search, order, a, b, rank);
        if (proof.found) {
            const std::array<const Placings*, 2> placings{&pistons.placings, &rods.placings};
            for (std::size_t kind = 0; kind < 2; ++kind) {
                for (std::size_t place = 0; place < search.places; ++place) {
                    best.from[kind][place] =
                        placings[kind]->from[(*proof.found)[kind] * search.places + place];
                }
            }
        }
        best.least = proof.least;
        best.proven = proof.least == infinity;
    }
    best.size = size_of(search, best.from);
    best.least = std::min(best.least, best.size);
    best.moved = moved_of(best.from);
    return best;
}

}  // namespace

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

}  // namespace ravnoves::workshop
