// How parts of a study are written, and read again.

#include <algorithm>
#include <type_traits>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/json_text.h"
#include "case-file/object_reader.h"
#include "case-file/sha256.h"
#include "studies/study_run.h"

namespace ravnoves::studies {

namespace {

constexpr std::string_view part_format = "ravnoves-study-part";
constexpr int part_version = 3;

}  // namespace

/// The values of a part one behind the other: each is written to the end of a list, or read from it
/// in the same order.
class PartValues {
  public:
    PartValues() = default;
    explicit PartValues(Json written) : values_(std::move(written)), is_reading_(true) {}

    const Json& written() const { return values_; }

    /// A vector has as many values as there are in it.
    template <typename... Values>
    void operator()(Values&... values) {
        (one(values), ...);
    }
    void operator()(Part& part) {
        list(part.origin.files_sha256);
        list(part.file_notes);
        (*this)(part.origin.program, part.origin.scene, part.origin.title, part.origin.case_sha256,
                part.basis, part.blocks);
        for (Row& row : part.rows) {
            list(row);
        }
        if (is_reading_) {
            part.tally = Tally(part.basis.plan, part.study.vary.size());
        }
        part.tally.pass(*this);
    }

  private:
    /// Of any number.
    template <typename Each>
    void list(std::vector<Each>& all) {
        std::uint64_t count = all.size();
        one(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            one(is_reading_ ? all.emplace_back() : all[i]);
        }
    }
    template <typename Value>
    requires(std::is_arithmetic_v<Value> ||
             std::is_same_v<Value, std::string>) void one(Value& value) {
        if (!is_reading_) {
            values_.push_back(value);
        } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
            // A float beyond its range would have no conversion.
            value = static_cast<Value>(values_.at(at_++).get_ref<const Json::number_integer_t&>());
        } else {
            value = values_.at(at_++).get<Value>();
        }
    }
    template <typename Each>
    void one(std::vector<Each>& all) {
        std::for_each(all.begin(), all.end(), [&](Each& each) { one(each); });
    }
    template <typename Value>
    void one(std::optional<Value>& value) {
        bool is_there = value.has_value();
        one(is_there);
        if (is_there) {
            one(value ? *value : value.emplace());
        }
    }
    /// Of counts those that are not 0, each behind how many others.
    void one(std::vector<std::int64_t>& counts) {
        for (auto at = counts.begin();; ++at) {
            const auto is_count = [](std::int64_t count) { return count != 0; };
            std::int64_t others = is_reading_ ? 0 : std::find_if(at, counts.end(), is_count) - at;
            one(others);
            if (others < 0 || others > counts.end() - at) {
                throw InputError("/values", not_ours);
            }
            at += others;
            if (at == counts.end()) {
                return;
            }
            one(*at);
        }
    }
    void one(Message& message) {
        std::string text = message.english();
        one(text);
        message = text;
    }
    void one(Rejections& rejections) {
        std::vector<Rejection> all;
        for (const auto& [kind, rejection] : rejections) {
            all.push_back(rejection);
        }
        list(all);
        for (const Rejection& each : all) {
            rejections[without_numbers(each.reason.message().english())] = each;
        }
    }
    void one(Block& block) {
        std::uint64_t samples = block.to - block.from;
        (*this)(samples, block.sums);
        if (samples != block.to - block.from) {
            throw InputError("/values", not_ours);
        }
    }
    void one(std::pair<std::string, std::string>& two) { (*this)(two.first, two.second); }
    void one(Rejection& x) { (*this)(x.count, x.first, x.reason.where, x.reason.why); }
    void one(Law& x) { (*this)(x.normal, x.mean, x.deviation, x.low, x.high); }
    void one(Taylor::Slope& x) { (*this)(x.value, x.error); }
    void one(Taylor& x) { (*this)(x.value, x.slopes); }
    void one(CountingPlan& x) { (*this)(x.low, x.width, x.centre, x.period, x.min, x.max); }
    void one(Sums& x) {
        one(x.n);
        if (x.n != 0.0) {
            (*this)(x.sum, x.squares, x.versines, x.sines);
        }
    }
    void one(Basis& x) {
        (*this)(x.laws, x.nominal, x.expansions, x.plan, x.distances, x.rejections);
    }

    Json values_ = Json::array();
    std::size_t at_ = 0;
    bool is_reading_ = false;
};

namespace {

/// @param what  a copy: what is written is passed as it is read
template <typename What>
Json written(What what) {
    PartValues values;
    values(what);
    return values.written();
}

std::string sum_of(const Json& part) {
    return sha256(json_text(part, JsonLayout::one_line));
}

}  // namespace

void Tally::pass(PartValues& values) {
    values(solved_, rejections_, slice_counts_, pair_counts_);
    for (Value& value : values_) {
        values(value.bins, value.min, value.max, value.within, value.slices, value.pairs);
        // Each solved sample is in one bin, and lies within the limits or not.
        std::uint64_t counted = 0;
        bool holds = value.within >= 0 && (solved_ == 0 || value.min <= value.max) &&
                     static_cast<std::uint64_t>(value.within) <= solved_;
        for (const std::int64_t bin : value.bins) {
            holds = holds && bin >= 0 && static_cast<std::uint64_t>(bin) <= solved_;
            counted += static_cast<std::uint64_t>(bin);
        }
        if (!holds || counted != solved_) {
            throw InputError("/values", not_ours);
        }
    }
}

bool same_basis(const Basis& one, const Basis& other) {
    return written(one) == written(other);
}

Json write_part(const Part& part) {
    Json json = {
        {"format", part_format}, {"version", part_version},          {"shard", part.shard},
        {"shards", part.shards}, {"study", write_study(part.study)}, {"values", written(part)}};
    json["sha256"] = sum_of(json);
    return json;
}

Part read_part(Json json) {
    ObjectReader reader(json, "");
    constexpr Word formats[]{{part_format}};
    reader.choice("format", formats);
    if (reader.raw("version") != part_version) {
        throw InputError("/version",
                         {Text::tr("must be %1; run the parts of other versions again"),
                          std::to_string(part_version)},
                         show(json["version"]));
    }
    const std::string sum = reader.text("sha256");
    json.erase("sha256");
    if (sum != sum_of(json)) {
        throw InputError(
            "/sha256",
            Text::tr("is not the checksum of the part: the part was changed; run it again"));
    }
    const std::uint64_t shards = reader.whole("shards", 1, max_blocks);
    const std::uint64_t shard = reader.whole("shard", 1, shards);
    try {
        Part part = empty_part(read_study(reader.raw("study")), shard, shards);
        PartValues values(reader.raw("values"));
        values(part);
        auto solved = static_cast<double>(part.tally.solved() * part.basis.plan.size());
        for (const Block& block : part.blocks) {
            for (const Sums& each : block.sums) {
                solved -= each.n;
            }
        }
        if (solved != 0.0) {
            throw InputError("/values", not_ours);
        }
        return part;
    } catch (const Json::exception&) {
        throw InputError("", not_ours);
    }
}

}  // namespace ravnoves::studies
