// What is doubted is no answer: not on the page, not on the card, not in the journal.

#include <QPushButton>
#include <algorithm>

#include "core/workshop/doubted_jobs.h"
#include "job_page_test.h"
#include "shop/model/verdict.h"
#include "workshop/solver.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class DoubtedJobTest : public PlugsPageTest {
  protected:
    void load(Json input, std::string_view name) {
        input["job"]["engine_number"] = name;
        model->loadInput(input, {});
    }
    bool isDoubted(const workshop::DoubtRule& rule) const {
        return std::ranges::any_of(model->doubts(), [&](const workshop::Doubt& doubt) {
            return doubt.rule->word == rule.word;
        });
    }
    /// All that the parts of the page say, but what is said not to be used.
    QStringList said() const {
        QStringList texts;
        for (const PagePart& part : model->parts()) {
            const Content content = model->part(part.id);
            if (const auto* results = std::get_if<Results>(&content)) {
                for (const ResultRow& row : results->rows) {
                    texts << row.texts();
                }
            } else if (const auto* notes = std::get_if<Notes>(&content)) {
                for (const auto& [severity, text] : notes->lines) {
                    texts << (text == model->doubtfulText() ? QString() : text);
                }
            }
        }
        return texts;
    }
    QStringList bold() const {
        QStringList texts;
        for (const QLabel* each : page.findChildren<QLabel*>()) {
            if (each->font().bold() && each->isVisible()) {
                texts << each->text();
            }
        }
        return texts;
    }
    void expectNothingToDo(const workshop::DoubtRule& rule) {
        const auto found = workshop::solve(model->input()).shaft.bob_weight;
        const QString weight = Words().number(found.value_or(0.0), units::gram, 1);
        const QString pass = verdictText(Words(), u"passes"_s);
        EXPECT_EQ(model->verdictShown()->severity, Severity::error);
        EXPECT_TRUE(model->holeResults().rows.isEmpty());
        EXPECT_EQ(model->limitText().isEmpty(), model->withheld().limits)
            << "what is not doubted is said";
        EXPECT_EQ(said().filter(pass), QStringList());
        const QString doubtful = model->doubtfulText();
        EXPECT_EQ(doubtful.contains(weight), rule.blocks.bob_weight);
        const QString card = this->card().simplified().remove(doubtful.simplified());
        const qsizetype stop = card.indexOf(u"STOP: do not drill yet"_s);
        const qsizetype limit = card.indexOf(model->limitText().simplified());
        EXPECT_EQ(limit > stop, !model->withheld().limits);
        for (const workshop::Doubt& doubt : model->doubts()) {
            if (doubt.rule->blocks.any()) {
                // What is to be done comes first.
                const qsizetype why = card.indexOf(Words().message(doubt.text).simplified());
                EXPECT_TRUE(stop >= 0 && stop < why) << stop << ' ' << why;
            }
        }
        EXPECT_FALSE(has(card, pass));
        EXPECT_FALSE(has(card, model->holeResults().columns[3].heading));
        if (rule.blocks.bob_weight) {
            EXPECT_EQ(label("headline"), u"STOP: no bob weight yet"_s);
            EXPECT_EQ(label("hang"), QString());
            EXPECT_EQ((said() + bold()).filter(weight), QStringList());
            EXPECT_TRUE(model->lineResults().rows.isEmpty());
            EXPECT_FALSE(has(card, weight));
            EXPECT_EQ(model->adviceText() + model->boringText(), QString());
            EXPECT_TRUE(model->optionResults().rows.isEmpty());
        }
        bool isSaved = false;
        model->desk()->saveJob(&isSaved);
        ASSERT_TRUE(isSaved);
        const auto row = model->desk()->journal()->job(model->desk()->jobId());
        const bool isRead = row->verdict == otherBobWeight || row->verdict == otherCrankshaft;
        EXPECT_TRUE(row->verdict == stopped || isRead) << qPrintable(row->verdict);
        EXPECT_FALSE(row->isFinished);
        EXPECT_EQ(row->bobWeight.has_value(), found && !rule.blocks.bob_weight);
    }
};

TEST_F(DoubtedJobTest, HasNoHoleNoWeightAndNoPassAnywhere) {
    int blocking = 0;
    for (const workshop::DoubtRule& rule : workshop::doubt_rules()) {
        if (!rule.blocks.any()) {
            continue;
        }
        ++blocking;
        SCOPED_TRACE(rule.word);
        Json input = workshop::test::doubted().at(rule.word)();
        load(input, rule.word);
        ASSERT_TRUE(isDoubted(rule));
        expectNothingToDo(rule);
        // The same with readings that would pass.
        for (Json& reading : input["correction"]["readings"]) {
            reading["unbalance_g_mm"] = 12.5;
        }
        load(input, std::string(rule.word) + " 2");
        if (isDoubted(rule)) {
            expectNothingToDo(rule);
        } else {
            // Nothing is planned then, or what was drilled acted as it was to.
            constexpr std::string_view lifted[] = {"drilled-otherwise", "great-reading",
                                                   "half-sector", "deepens-unmeasured"};
            EXPECT_NE(std::ranges::find(lifted, rule.word), std::end(lifted));
        }
    }
    EXPECT_GE(blocking, 10);
    EXPECT_EQ(verdictKind(stopped), VerdictKind::Fail) << "red in the journal as on the page";
}

TEST_F(DoubtedJobTest, IsAnsweredWhereADoubtBlocksNothing) {
    for (const workshop::DoubtRule& rule : workshop::doubt_rules()) {
        if (rule.blocks.any()) {
            continue;
        }
        SCOPED_TRACE(rule.word);
        load(workshop::test::doubted().at(rule.word)(), rule.word);
        ASSERT_TRUE(isDoubted(rule));
        EXPECT_EQ(model->holeResults().rows.isEmpty(), model->solution().newest()->passes());
        EXPECT_EQ(card().contains(model->holeResults().columns[3].heading),
                  !model->holeResults().rows.isEmpty());
        EXPECT_EQ(model->doubtfulText(), QString());
        // It is said: beside the verdict or in it.
        const QString shown = Words().message(model->verdictShown()->text);
        for (const workshop::Doubt& doubt : model->doubts()) {
            const QString text = Words().message(doubt.text);
            EXPECT_TRUE(shown.contains(text) || model->troubles().contains(text))
                << qPrintable(text);
        }
    }
}

TEST_F(DoubtedJobTest, SwapsTheColumnsByTheButtonOfTheVerdict) {
    Json weighed = workshop::test::doubted().at("swapped-ends")();
    weighed["correction"].erase("readings");  // they would be of another bob weight
    load(weighed, "1");
    auto* act = find<QPushButton>("verdict_act");
    ASSERT_TRUE(act->isVisible());
    EXPECT_EQ(act->text(), u"Swap the rod ends"_s);
    EXPECT_TRUE(model->takeOffResults().rows.isEmpty());
    QTest::mouseClick(act, Qt::LeftButton);
    const auto& sheet = *model->input().weigh_in;
    EXPECT_NEAR(*sheet[shop::Part::rod_big_end].mass[0], 429.8 * units::gram, 1e-12);
    EXPECT_NEAR(*sheet[shop::Part::rod_small_end].mass[7], 162.4 * units::gram, 1e-12);
    EXPECT_TRUE(model->doubts().empty());
    EXPECT_FALSE(act->isVisible());
    EXPECT_TRUE(model->solution().bob_weight);
    EXPECT_NE(model->verdictShown()->severity, Severity::error);
    model->history()->undo();
    EXPECT_TRUE(model->withheld().bob_weight);
    // The same of ends that are typed.
    Json typed = workshop::test::card();
    std::swap(typed["parts_g"]["small_end"], typed["parts_g"]["big_end"]);
    typed["correction"].erase("readings");
    load(typed, "2");
    QTest::mouseClick(act, Qt::LeftButton);
    EXPECT_NEAR(*model->input().parts.big_end, 429.8 * units::gram, 1e-12);
    EXPECT_FALSE(model->withheld().any());
}

}  // namespace
}  // namespace ravnoves
