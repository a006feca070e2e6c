#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/message.h"
#include "studies/study.h"
#include "studies/tally.h"
#include "studies/taylor.h"

namespace ravnoves {
struct CaseFile;
}

namespace ravnoves::studies {

/// Sees how much of some work is done, 0…1, and may stop it by false; may be empty.
using KeepGoing = std::function<bool(double done)>;

/// The progress of work that several workers share.
class Progress {
  public:
    /// @param keep_going  must outlive this
    /// @param total       steps of the whole work
    Progress(const KeepGoing& keep_going, std::uint64_t total)
        : keep_going_(keep_going), total_(static_cast<double>(total)) {}

    /// After a step of a worker; the first one tells of all steps, in its thread.
    /// @return false where the work is to stop
    bool step(std::size_t worker) {
        const auto done = static_cast<double>(++done_);
        if (worker == 0 && keep_going_) {
            stopped_ = !keep_going_(done / total_);
        }
        return !stopped_;
    }
    bool is_stopped() const { return stopped_; }

  private:
    const KeepGoing& keep_going_;
    double total_;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<bool> stopped_{false};
};

/// Calls work(worker, i) for each i below count until one returns false: each worker takes the next
/// free one. The first worker is the thread that calls, which does the work of those for
/// which the machine gives no thread. What one throws is thrown again when all have ended.
template <typename Work>
void share_out(std::size_t workers, std::uint64_t count, const Work& work) {
    std::atomic<std::uint64_t> next{0};
    std::atomic<bool> stopped{false};
    const auto take = [&](std::size_t worker) {
        for (std::uint64_t i = next++; i < count && !stopped; i = next++) {
            if (!work(worker, i)) {
                stopped = true;
            }
        }
    };
    std::vector<std::future<void>> others;
    for (std::size_t worker = 1; worker < workers; ++worker) {
        others.push_back(std::async(take, worker));
    }
    take(0);
    for (std::future<void>& other : others) {
        other.get();
    }
}

/// What a study is of.
struct Origin {
    std::string scene;
    std::string title;
    std::string case_sha256;  ///< of the unchanged case file, or of the case as written
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
    std::function<std::unique_ptr<Response>()> make;    ///< one for each thread
    std::vector<Message> file_notes{};                  ///< of the files that the case names
};

/// The tolerance that a case has by itself, by the data of its files. Nothing where one of these is
/// of the same input.
std::optional<Varied> open_input(const CaseFile& file, const CaseContext& context,
                                 const std::vector<Varied>& typed);

/// The study of a case.
/// @param text  the case file's bytes, for its sum; empty: as written
/// @throws InputError
Problem problem_of(const CaseFile& file, const CaseContext& context, std::string_view text = {});

/// What every part of a study begins with, the same in each: the expansions about the means and
/// how values are counted, from the study's first samples.
struct Basis {
    std::vector<Law> laws;                       ///< not of a grid
    std::vector<std::optional<double>> nominal;  ///< the watched values
    std::vector<Taylor> expansions;
    std::vector<CountingPlan> plan;
    // Some samples try the expansions:
    std::vector<double> distances;  ///< root mean square of the values' from the expansions
    Rejections rejections;
};

/// A row of a grid's table; a value that does not exist is empty.
using Row = std::vector<std::optional<double>>;

/// A study that is done, or a shard of one.
struct Part {
    Origin origin;
    Study study;
    Basis basis{};
    std::uint64_t shard = 1;  ///< from 1
    std::uint64_t shards = 1;
    std::vector<Block> blocks{};
    Tally tally{};
    std::vector<Row> rows{};  ///< of a grid, by point from the first block's first one
    std::vector<Message> file_notes{};

    std::uint64_t size() const;  ///< samples
};

/// A study has as many blocks, or as many as samples; a shard is whole blocks.
inline constexpr std::uint64_t max_blocks = 1024;
/// As large as the study makes a shard, for its values to be found or read.
Part empty_part(Study study, std::uint64_t shard, std::uint64_t shards);
/// Samples that the expansions are tried by.
inline constexpr std::uint64_t tried_samples = 64;

/// Solves a study or a shard of one.
/// @param threads     0: as many as there are cores
/// @param keep_going  is called in this thread
/// @return nothing where it was stopped
std::optional<Part> run_study(const Problem& problem, std::uint64_t shard = 1,
                              std::uint64_t shards = 1, int threads = 0,
                              const KeepGoing& keep_going = {});

/// Puts the parts of one study together, in any order; at least one is named.
/// @param read  gives the part of a name, one at a time
/// @throws InputError that names a part that was there already or is of another study, or the parts
/// that are missing
Part merge_parts(const std::vector<std::string>& names,
                 const std::function<Part(const std::string&)>& read);

/// With a sum over itself.
Json write_part(const Part& part);
/// @throws InputError where it is of another version, or not as it was written
Part read_part(Json json);

/// Whether two parts of a study began with the same numbers.
bool same_basis(const Basis& one, const Basis& other);

/// What a study has found of a watched value, as its method says it.
struct Found {
    std::optional<Taylor::Propagated> linear{};
    /// Nothing without a solved sample, or where a linear study has no slopes; of a single sample
    /// the deviation says nothing.
    std::optional<Statistics> statistics{};
};
Found found_of(const Part& part, std::size_t watched);

/// A note on an answer.
struct Note {
    Message text;
    std::optional<std::size_t> fails{};  ///< of the watched value whose linear answer fails
};
/// Of the files that the case names; where the linear answer fails; what too few samples do not
/// tell.
std::vector<Note> noted(const Part& part);

/// Why samples were rejected, the most frequent first.
std::vector<Rejection> rejections_of(const Part& part);

/// The "ravnoves-study" document.
Json write_results(const Part& part);
/// SHA-256 of the case whose study is in such a document; empty for other documents.
std::string case_of_results(const Json& json);

}  // namespace ravnoves::studies
