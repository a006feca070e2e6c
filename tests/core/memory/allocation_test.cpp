// Every reader where one allocation fails, or all from one on: what it reads is whole, or it ends
// by bad_alloc or in words, never the program.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <set>
#include <string>
#include <vector>

#include "balance-shaft/table_reading.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/json_text.h"
#include "case-file/text_file.h"
#include "example_check.h"
#include "scenes/scenes.h"
#include "shop/scale_line.h"
#include "studies/study_run.h"
#include "temporary_folder.h"

// What an exception leaves behind in the library's constructors is lost, not used again.
extern "C" {
[[gnu::weak]] void __lsan_disable();  // NOLINT(*-reserved-identifier): of the sanitizer
[[gnu::weak]] void __lsan_enable();   // NOLINT(*-reserved-identifier)
}

namespace {

/// Of this thread; while it is armed, allocations are counted.
struct Scarcity {
    bool armed = false;
    bool for_good = false;    ///< whether those after the failing one fail, too
    std::size_t taken = 0;    ///< allocations
    std::size_t bytes = 0;    ///< of all of them
    std::size_t failing = 0;  ///< from 1; 0: none
};
thread_local Scarcity scarcity;

void* take(std::size_t size) {
    if (scarcity.armed) {
        const std::size_t number = ++scarcity.taken;
        scarcity.bytes += size;
        const bool fails =
            scarcity.failing != 0 &&
            (scarcity.for_good ? number >= scarcity.failing : number == scarcity.failing);
        if (fails) {
            throw std::bad_alloc();
        }
    }
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return take(size);
}
void* operator new[](std::size_t size) {
    return take(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

struct Read {
    std::string name;
    std::function<std::string()> what;  ///< reads, and says in words what was read
};

/// Runs it where an allocation fails.
/// @return what was read; nothing where there was no memory, or so it said
std::optional<std::string> read_with(const Read& read, std::size_t failing, bool for_good) {
    if (__lsan_disable != nullptr) {
        __lsan_disable();
    }
    std::optional<std::string> found;
    scarcity = {.armed = true, .for_good = for_good, .failing = failing};
    try {
        found = read.what();
    } catch (const std::bad_alloc&) {
        // so it says
    } catch (const InputError&) {
        // in words
    }
    scarcity.armed = false;
    if (__lsan_enable != nullptr) {
        __lsan_enable();
    }
    return found;
}

void expect_survives(const Read& read) {
    SCOPED_TRACE(read.name);
    const auto expected = read_with(read, 0, false);
    ASSERT_TRUE(expected);
    const std::size_t allocations = scarcity.taken;
    ASSERT_GT(allocations, 0U);
    // Of many, some: the first ones, where all begins, and every so many-th.
    constexpr std::size_t maximum = 400;
    const std::size_t step = 1 + allocations / maximum;
    int failed = 0;
    for (const bool for_good : {false, true}) {
        for (std::size_t n = 1; n <= allocations; n += n < maximum / 4 ? 1 : step) {
            const auto found = read_with(read, n, for_good);
            failed += found ? 0 : 1;
            EXPECT_TRUE(!found || *found == *expected) << n << " of " << allocations;
        }
    }
    EXPECT_GT(failed, 0);
    EXPECT_TRUE(read_with(read, 0, false) == expected) << "afterwards";
}

std::string written(const Json& json) {
    return json_text(json, JsonLayout::one_line);
}

TEST(Allocations, OfCasesAndSolutionsMayFail) {
    std::set<std::string> scenes;  // one case of each is solved
    for (const auto& path : test::example_files()) {
        const std::string text = read_text_file(path);
        const std::string name = path.filename().string();
        expect_survives({name, [&] { return written(write_case(parse_case(text))); }});
        if (scenes.insert(parse_case(text).scene).second) {
            expect_survives({name, [&] { return written(solve_case(parse_case(text), {})); }});
        }
    }
}

std::string study_text() {
    Json document = write_case(test::example("tmz-650d"));
    document["study"] = {{"vary", {{"/crank_radius_mm", {{"plus_minus", 0.02}}}}},
                         {"watch", {{"/metrics/M_ups/range_Nm", {{"max", 1083}}}}},
                         {"samples", 40}};
    return written(document);
}

studies::Part part_of(const std::string& text) {
    const studies::Problem problem = studies::problem_of(parse_case(text), {});
    studies::Part part = studies::begin_part(problem, 1, 1, 1);
    studies::run_part(problem, part, 1);
    return part;
}

TEST(Allocations, OfStudiesMayFail) {
    const std::string text = study_text();
    expect_survives({"study", [&] { return written(studies::write_results(part_of(text))); }});
    const std::string part = written(studies::write_part(part_of(text)));
    expect_survives({"part", [&] {
                         studies::PartMerger merger;
                         merger.add(studies::read_part(parse_json(part)), "part");
                         return written(studies::write_results(merger.finish()));
                     }});
}

TEST(Allocations, OfTablesMayFail) {
    std::string table;
    std::string pressure = "deg;bar\n";
    for (int angle = 0; angle <= 720; angle += 5) {
        table += std::to_string(angle) + ";" + std::to_string(angle % 180) + ",5\n";
        pressure += std::to_string(angle) + ";" + std::to_string(angle % 180 + 1) + "\n";
    }
    table.replace(table.rfind(';') + 1, std::string::npos, "0,5\n");
    expect_survives({"torque", [&] {
                         return balance_shaft::write_torque_table(
                             balance_shaft::parse_torque_table(table).table);
                     }});
    expect_survives({"pressure", [&] {
                         const auto trace = balance_shaft::parse_pressure_trace(pressure);
                         return trace.describe().english();
                     }});
}

// A row of many columns makes no such columns of the rows of two below it.
TEST(Allocations, OfWideTablesAreOfTheirSize) {
    constexpr std::size_t columns = 20'000;
    std::string row;
    for (std::size_t i = 0; i < columns; ++i) {
        row += "1;";
    }
    std::string table = row + "\n" + row + "\n" + row + "\n";
    for (std::size_t i = 0; i < columns; ++i) {
        table += "1;2\n";
    }
    read_with({"wide",
               [&] {
                   const auto proposal =
                       balance_shaft::propose_reading(table, balance_shaft::Measured::pressure);
                   return std::to_string(proposal.columns);
               }},
              0, false);
    EXPECT_LT(scarcity.bytes, 2000 * table.size());
}

TEST(Allocations, OfLinesMayFail) {
    expect_survives({"scale", [] {
                         shop::ScaleLines lines;
                         std::string read;
                         const std::string sent = "ST,GS,+0001234.5  g\r\n1234.56 g\r\n" +
                                                  std::string(100, '?') + "\r\n";
                         lines.add(sent);
                         for (std::string line; lines.next(line);) {
                             read += std::to_string(shop::parse_scale_line(line).mass()) + '\n';
                         }
                         return read;
                     }});
}

TEST(Allocations, OfFilesMayFail) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "file";
    const std::string text(300'000, 'x');
    write_text_file(file, text + "\nb\n");
    expect_survives({"file", [&] { return read_text_file(file); }});
    // A line for which there is no memory is not handed out, the next one is.
    const Read lines{"lines", [&] {
                         const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
                         std::string read;
                         std::string last;
                         try {
                             LineReader reader(descriptor);
                             for (std::string line; reader.next(line);) {
                                 last = line;
                                 reader.check_kept();
                                 read += line + '\n';
                             }
                         } catch (const std::bad_alloc&) {
                             ::close(descriptor);
                             throw;
                         }
                         ::close(descriptor);
                         return read;
                     }};
    expect_survives(lines);
    // What is not written whole is not there.
    expect_survives({"written", [&] {
                         write_text_file(folder.path() / "a file of a name that is not short",
                                         text);
                         return std::string("written");
                     }});
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        EXPECT_EQ(read_text_file(entry.path()).substr(0, text.size()), text) << entry.path();
    }
}

}  // namespace
}  // namespace ravnoves
