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
constexpr long exchange_work = 24'000'000;  // additions in the search by exchanges
constexpr long proof_work = 40'000'000;     // boxes and points compared in the proof

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

/// A placing that is changed set by set; what it adds up to follows.
class Placing {
  public:
    Placing(const SetSearch& search, From from)
        : search_(search),
          from_(std::move(from)),
          sum_(sum_of(search, from_)),
          moved_(moved_of(from_)) {
        for (std::size_t kind = 0; kind < 2; ++kind) {
            for (std::size_t place = 0; place < search.places; ++place) {
                touched_[kind].push_back(touched(kind, place));
            }
        }
        for (const double each : sum_) {
            mean_ += each / static_cast<double>(sum_.size());
        }
    }

    const From& from() const { return from_; }
    Rank rank() const { return {size_of(sum_, search_.size), moved_}; }
    /// The sets of two places change.
    void exchange(std::size_t kind, std::size_t p, std::size_t q) {
        const int set = from_[kind][p];
        put(kind, p, from_[kind][q]);
        put(kind, q, set);
    }
    void keep() {
        kept_ = sum_;
        kept_moved_ = moved_;
    }
    /// After the exchanges are taken back: the sum as it was, without their rounding.
    void restore() {
        sum_ = kept_;
        moved_ = kept_moved_;
    }
    /// What annealing makes small: the size, and what leads it on where many placings have the
    /// same.
    /// @param per_move  what a move is worth
    double energy(double per_move) const {
        if (search_.size == SetSearch::Size::norm) {
            return size_of(sum_, search_.size);
        }
        double least = infinity;
        double most = -infinity;
        double squares = 0.0;
        for (const double each : sum_) {
            least = std::min(least, each);
            most = std::max(most, each);
            squares += (each - mean_) * (each - mean_);
        }
        return search_.enough > 0.0
                   ? std::max(0.0, most - least - search_.enough) + per_move * moved_
                   : most - least + std::sqrt(squares / static_cast<double>(sum_.size()));
    }

  private:
    struct Range {
        std::size_t begin;
        std::size_t end;
    };
    /// The numbers to which a place adds.
    Range touched(std::size_t kind, std::size_t place) const {
        Range range{search_.dimensions, 0};
        for (std::size_t set = 0; set < search_.places; ++set) {
            const double* adds = adds_of(search_, kind, static_cast<int>(set), place);
            for (std::size_t i = 0; i < search_.dimensions; ++i) {
                if (adds[i] != 0.0) {
                    range = {std::min(range.begin, i), std::max(range.end, i + 1)};
                }
            }
        }
        return range;
    }
    void put(std::size_t kind, std::size_t place, int set) {
        int& now = from_[kind][place];
        const double* off = adds_of(search_, kind, now, place);
        const double* on = adds_of(search_, kind, set, place);
        const Range range = touched_[kind][place];
        for (std::size_t i = range.begin; i < range.end; ++i) {
            sum_[i] += on[i] - off[i];
        }
        const int home = static_cast<int>(place);
        moved_ += (set != home ? 1 : 0) - (now != home ? 1 : 0);
        now = set;
    }

    const SetSearch& search_;
    From from_;
    Values sum_;
    int moved_;
    double mean_ = 0.0;
    std::array<std::vector<Range>, 2> touched_;
    Values kept_;
    int kept_moved_ = 0;
};

/// Places whose sets may change.
struct Pair {
    std::size_t kind;
    std::size_t p;
    std::size_t q;
};

std::vector<Pair> pairs_of(const SetSearch& search) {
    std::vector<Pair> pairs;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const auto& group = search.kinds[kind].group;
        for (std::size_t p = 0; p < search.places; ++p) {
            for (std::size_t q = p + 1; q < search.places; ++q) {
                if (group[p] == group[q]) {
                    pairs.push_back({kind, p, q});
                }
            }
        }
    }
    return pairs;
}

/// Looks for better placings by exchanges, within a bound of its work.
class Exchanges {
  public:
    explicit Exchanges(const SetSearch& search)
        : search_(search), order_(search), pairs_(pairs_of(search)) {}

    bool tries_two_pairs() const { return is_affordable(pairs_.size() * pairs_.size() / 2); }
    bool is_worth_it() const { return work_ > 0 && !pairs_.empty(); }
    /// Exchanges two sets, three in turn or two times two, as long as that helps.
    void improve(From& from, Rank& rank) {
        Placing placing(search_, from);
        while (step(placing, rank, &Exchanges::try_two) ||
               step(placing, rank, &Exchanges::try_three) ||
               step(placing, rank, &Exchanges::try_two_pairs)) {
        }
        from = placing.from();
    }
    /// Random exchanges that may make it worse by less and less.
    /// @param share  of the work
    void anneal(From& from, double share) {
        Placing placing(search_, from);
        const double begin = placing.energy(0.0);
        const double per_move = 0.1 * begin / static_cast<double>(2 * search_.places);
        const auto steps = static_cast<long>(share * exchange_work) / cost(2);
        constexpr double first = 0.3;
        constexpr double last = 1e-5;
        const double cooling =
            std::pow(last / first, 1.0 / static_cast<double>(std::max(1L, steps)));
        double allowed = first * begin;
        double now = placing.energy(per_move);
        From best = from;
        double least = now;
        for (long step = 0; step < steps; ++step) {
            const Pair& pair = pairs_[random_() % pairs_.size()];
            placing.keep();
            placing.exchange(pair.kind, pair.p, pair.q);
            const double then = placing.energy(per_move);
            if (then < now + allowed * uniform()) {
                now = then;
                if (now < least) {
                    least = now;
                    best = placing.from();
                }
            } else {
                placing.exchange(pair.kind, pair.p, pair.q);
                placing.restore();
            }
            allowed *= cooling;
        }
        work_ -= steps * cost(2);
        from = best;
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
    /// Whether one exchange of two sets, or of three in turn, makes the present placing small
    /// enough; the best of the fewest moves, which no placing has fewer of. The present one itself
    /// is not enough.
    std::optional<From> fewest(const From& as_it_is) {
        Placing placing(search_, as_it_is);
        Rank best = placing.rank();
        const auto is_enough = [&](const Rank& rank) { return rank.size <= search_.enough; };
        try_two(placing, best);
        if (!is_enough(best)) {
            try_three(placing, best);
        }
        return is_enough(best) && best.moved <= 3 ? std::optional(found_) : std::nullopt;
    }

  private:
    long cost(long exchanges) const {
        return static_cast<long>(search_.dimensions) + 4 * exchanges + 8;
    }
    double uniform() { return static_cast<double>(random_()) / 4294967296.0; }
    void carry_out(Placing& placing, const Pair& first, const std::optional<Pair>& second) {
        placing.exchange(first.kind, first.p, first.q);
        if (second) {
            placing.exchange(second->kind, second->p, second->q);
        }
    }
    /// Tries exchanges and takes them back. @return whether they are better than what was best
    bool attempt(Placing& placing, Rank& best, const Pair& first,
                 const std::optional<Pair>& second = {}) {
        carry_out(placing, first, second);
        const Rank rank = placing.rank();
        const bool helps = order_.is_better(rank, best);
        if (helps) {
            best = rank;
            found_ = placing.from();
            steps_ = {first, second};
        }
        if (second) {
            placing.exchange(second->kind, second->p, second->q);
        }
        placing.exchange(first.kind, first.p, first.q);
        placing.restore();
        work_ -= cost(second ? 4 : 2);
        return helps;
    }
    using Attempts = bool (Exchanges::*)(Placing&, Rank&);
    bool step(Placing& placing, Rank& best, Attempts attempts) {
        if (work_ <= 0 || !(this->*attempts)(placing, best)) {
            return false;
        }
        carry_out(placing, steps_.first, steps_.second);
        return true;
    }
    bool is_affordable(std::size_t attempts) const {
        return static_cast<double>(attempts) * static_cast<double>(cost(4)) <
               0.1 * static_cast<double>(exchange_work);
    }
    bool try_two(Placing& placing, Rank& best) {
        bool helps = false;
        placing.keep();
        for (const Pair& pair : pairs_) {
            helps = attempt(placing, best, pair) || helps;
        }
        return helps;
    }
    bool try_three(Placing& placing, Rank& best) {
        if (!is_affordable(pairs_.size() * search_.places)) {
            return false;
        }
        bool helps = false;
        placing.keep();
        for (const Pair& pair : pairs_) {
            const auto& group = search_.kinds[pair.kind].group;
            for (std::size_t r = pair.q + 1; r < search_.places; ++r) {
                if (group[r] == group[pair.p]) {
                    helps = attempt(placing, best, pair, Pair{pair.kind, pair.q, r}) || helps;
                    helps = attempt(placing, best, pair, Pair{pair.kind, pair.p, r}) || helps;
                }
            }
        }
        return helps;
    }
    bool try_two_pairs(Placing& placing, Rank& best) {
        if (!tries_two_pairs()) {
            return false;
        }
        bool helps = false;
        placing.keep();
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            for (std::size_t k = i + 1; k < pairs_.size(); ++k) {
                helps = attempt(placing, best, pairs_[i], pairs_[k]) || helps;
            }
        }
        return helps;
    }

    const SetSearch& search_;
    Order order_;
    std::vector<Pair> pairs_;
    std::mt19937 random_{1};
    long work_ = exchange_work;
    From found_;
    std::pair<Pair, std::optional<Pair>> steps_;
};

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
    Exchanges exchanges(search);
    // Of the work, each time: a long annealing stands in for what is too much to try.
    const double annealed = exchanges.tries_two_pairs() ? 0.01 : 0.2;
    for (int start = 0; exchanges.is_worth_it() && (start < 3 || !provable); ++start) {
        From from = as_it_is;
        // From what is fitted now the fewest move.
        if (start > 0 && (provable || search.enough <= 0.0)) {
            exchanges.shuffle(from);
        }
        if (start > 0 && !provable) {
            exchanges.anneal(from, annealed);
        }
        Rank found{size_of(search, from), moved_of(from)};
        exchanges.improve(from, found);
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
    } else if (rank.size <= search.enough || rank.size <= search.rounding) {
        // Nothing is smaller than is enough, and nothing than nothing: the moves decide.
        best.proven = rank.moved == 0 || search.enough <= 0.0;
        if (const auto few = best.proven ? std::nullopt : exchanges.fewest(as_it_is)) {
            best.from = *few;
            best.proven = true;
        }
    }
    best.size = size_of(search, best.from);
    best.least = std::min(best.least, best.size);
    best.moved = moved_of(best.from);
    return best;
}

}  // namespace

bool is_quick(const SetSearch& search) {
    constexpr std::size_t few = 720;  // 6!, or two groups of four
    return std::all_of(search.kinds.begin(), search.kinds.end(),
                       [](const SetKind& kind) { return placings_of(kind) <= few; });
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

}  // namespace ravnoves::workshop
