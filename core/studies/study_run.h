#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/message.h"
#include "studies/law.h"
#include "studies/response.h"
#include "studies/robust_best.h"
#include "studies/study.h"
#include "studies/tally.h"
#include "studies/taylor.h"

namespace ravnoves {
struct CaseFile;
}

namespace ravnoves::studies {

/// What a study is of.
struct Origin {
    std::string scene;
    std::string title;
    std::string case_sha256;  ///< of the case file as it is, or of the case as written
    /// Of the files that the case names.
    std::vector<std::pair<std::string, std::string>> files_sha256{};
    std::string program = RAVNOVES_VERSION;
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A study with what answers it.
struct Problem {
    Origin origin;
    Study study;
    std::vector<double> nominal;                        ///< the inputs, in the units of their keys
    std::vector<std::optional<double>> nominal_result;  ///< the watched values there
    MakeResponse make;
    std::vector<Message> file_notes{};  ///< of the files that the case names

    /// An angle that the scene chooses to make a value least (scenes/responses.h).
    struct Choice {
        std::string input;  ///< pointers
        std::string value;
        std::optional<double> nominal_best{};  ///< degrees, by the scene
        /// Stretches of angles that can be built, degrees, and why there is none; nothing where the
        /// scene knows none that cannot.
        std::optional<AngleStretches> buildable{};
        Message unbuildable{};
        /// The study's inputs and, unless it is one of them, the angle; the value and half its
        /// steepest slope per radian.
        MakeResponse make;
        /// Those that can be built of the same inputs; makes one for each thread. Nothing where
        /// that cannot be told.
        std::function<BuildableOf()> make_buildable{};
    };
    std::optional<Choice> choice{};
};

/// The study of a case.
/// @param text  the case file's bytes, for its sum; empty: as written
/// @throws InputError
Problem problem_of(const CaseFile& file, const CaseContext& context, std::string_view text = {});

/// What every part of a study begins with, the same in each: the expansions about the means and
/// how values are counted, from the study's first samples.
struct Basis {
    std::vector<Law> laws;                       ///< not of a grid
    std::vector<std::optional<double>> nominal;  ///< the watched values
    std::vector<double> periods;                 ///< of angles; else 0
    std::vector<Taylor> expansions;
    std::vector<Departure> departures;
    std::vector<CountingPlan> plan;
    std::uint64_t evaluations = 0;  ///< for the expansions and what they are tried by
    Refusals refusals;              ///< of them
    // What an expansion that stands for the study is tried by.
    std::uint64_t tried = 0;  ///< samples
    std::uint64_t tried_refused = 0;
    std::vector<double> distances;  ///< root mean square of the values' from their expansions
};

/// The watched values of a study's first samples, from which the basis was made.
struct FirstSamples;
/// The watched values of all samples of a part.
struct KeptValues;

/// A row of a grid's table; a value that does not exist is empty.
using Row = std::vector<std::optional<double>>;

/// A study or a shard of it, as far as it is done.
struct Part {
    Origin origin;
    Study study;
    Basis basis;
    std::uint64_t shard = 1;  ///< from 1
    std::uint64_t shards = 1;
    std::uint64_t from = 0;  ///< samples from … to
    std::uint64_t done = 0;  ///< the next sample
    std::uint64_t to = 0;
    Tally tally;
    std::vector<Row> rows;
    std::vector<Message> file_notes{};
    std::optional<RobustBest> robust_best{};  ///< of the first shard, where it was asked for
    // Not written:
    std::shared_ptr<const FirstSamples> first{};
    std::shared_ptr<KeptValues> kept{};

    bool finished() const { return done == to; }
};

/// The samples of a shard, from 1.
std::pair<std::uint64_t, std::uint64_t> shard_range(const Study& study, std::uint64_t shard,
                                                    std::uint64_t shards);

inline constexpr std::uint64_t most_shards = 1'000'000;

/// Sees now and then how much of all work is done, 0…1, and may stop it by false. The second makes
/// a part of the samples solved so far, for looking at: their values are counted by a plan that
/// these alone have made.
using Begun = std::function<bool(double done, const std::function<Part()>& so_far)>;

/// A part of which nothing is done yet. Its basis costs some thousand solutions at most.
/// @param begun  where it stops the work, the part is worth nothing
Part begin_part(const Problem& problem, std::uint64_t shard = 1, std::uint64_t shards = 1,
                int threads = 0, const Begun& begun = {});

/// How much of all work a part's samples and basis are, 0…1.
double share_done(const Part& part);

/// Keeps the watched values of a part that has just begun, where they are no more than `most`
/// numbers: other limits need no solution then.
void keep_values(Part& part, std::uint64_t most);
/// Counts what is within other limits of the same watched values, as the samples themselves did.
/// @return false where the values were not kept
bool change_limits(Part& part, const std::vector<Watched>& watch);

/// Goes on with a part until it is done. Several threads (0: as many as there are cores) work on
/// stretches of samples; after each stretch, some tenths of a second, `went_on` sees the part and
/// may stop the work by false.
void run_part(const Problem& problem, Part& part, int threads = 0,
              const std::function<bool(const Part&)>& went_on = {});

/// Some of the first samples of a study that runs here, for pictures: inputs, then watched values,
/// in the units of their keys. Those that were refused are left out.
std::vector<std::vector<double>> first_samples(const Part& part, std::size_t most);

/// Puts the finished parts of one study together, in any order, one at a time.
class PartMerger {
  public:
    /// @param name  what messages call the part
    /// @throws InputError where it is not finished, was there already or is of another study
    void add(Part part, const std::string& name);
    /// The whole study.
    /// @throws InputError that names the parts that are missing
    Part finish();

  private:
    std::optional<Part> whole_;
    std::string first_name_;
    std::uint64_t shards_ = 0;
    std::vector<std::string> names_;  ///< by shard; empty of one that is missing
    std::vector<std::vector<Row>> rows_;
};

Json write_part(const Part& part);
/// @throws InputError
Part read_part(const Json& json);

/// Whether two parts of a study began with the same numbers.
bool same_basis(const Basis& one, const Basis& other);

/// What is to be known of an answer.
struct Note {
    Message text;
    /// Of the watched value whose linear answer fails, or that of the second order where that is
    /// the method.
    std::optional<std::size_t> fails{};
};
/// Of the files that the case names; where the linear answer fails by more than its error bars, and
/// why; what too few samples do not tell.
std::vector<Note> noted(const Part& part);
std::vector<Message> notes_of(const Part& part);

/// Why samples were refused, the most frequent first.
std::vector<Refusal> refusals_of(const Part& part);

/// The "ravnoves-study" document; of a part that is not done yet, of its samples so far.
Json write_results(const Part& part);

}  // namespace ravnoves::studies
