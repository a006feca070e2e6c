#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/field_index.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "error_of.h"

namespace ravnoves {

namespace {

enum class Colour { red, green };
constexpr Word colours[] = {{"red", {}}, {"green", {}}};

struct Part {
    double mass = 0.0;  // kg
    bool operator==(const Part&) const = default;
};

struct Sample {
    double length = 0.0;  // m
    std::optional<double> depth;
    double share = 0.5;
    int teeth = 40;
    bool closed = false;
    std::string name;
    Colour colour = Colour::red;
    std::optional<Part> part;
    std::vector<Part> parts;
    bool in_rpm = true;
    double speed = 0.0;  // rad/s
    bool operator==(const Sample&) const = default;
};

namespace field {
constexpr Field length{.key = "length_mm", .unit = units::mm, .range = Range::greater_than(0)};
constexpr Field depth{.key = "depth_mm", .unit = units::mm, .range = Range::at_least(0)};
constexpr Field share{.key = "share", .range = Range::between(0, 1)};
constexpr Field teeth{.key = "teeth", .range = Range::between(6, 1000)};
constexpr Field closed{.key = "closed"};
constexpr Field name{.key = "name"};
constexpr Field colour{.key = "colour", .words = colours};
constexpr Field mass{.key = "mass_g", .unit = units::gram, .range = Range::at_least(0)};
constexpr Field part{.key = "part"};
constexpr Field parts{.key = "parts"};
constexpr Field rpm{.key = "speed_rpm", .unit = units::rpm, .range = Range::greater_than(0)};
constexpr Field speed{
    .key = "speed_rad_s", .unit = units::rad_per_s, .range = Range::greater_than(0)};
}  // namespace field

void visit_fields(FieldVisitor& visitor, Part& part) {
    visitor.number(field::mass, part.mass);
}

void visit_fields(FieldVisitor& visitor, Sample& sample) {
    visitor.number(field::length, sample.length);
    visitor.number(field::depth, sample.depth);
    visitor.number(field::share, sample.share, 0.5);
    visitor.integer(field::teeth, sample.teeth, 40);
    visitor.flag(field::closed, sample.closed, false);
    visitor.optional_text(field::name, sample.name);
    visitor.choice(field::colour, sample.colour, Colour::red, FieldVisitor::Written::always);
    visitor.object(field::part, sample.part);
    if (visitor.has(field::parts.key, !sample.parts.empty())) {
        visitor.list(field::parts, sample.parts);
    }
    const int which = visitor.one_of({field::rpm.key, field::speed.key}, sample.in_rpm ? 0 : 1);
    if (which != 1) {
        sample.in_rpm = true;
        visitor.number(field::rpm, sample.speed);
    }
    if (which != 0) {
        sample.in_rpm = which < 0;
        visitor.number(field::speed, sample.speed);
    }
}

Sample sample() {
    Sample s;
    s.length = 46 * units::mm;
    s.depth = 0.1 * units::mm;
    s.part = Part{0.645};
    s.parts = {{0.1}, {0.2}};
    s.colour = Colour::green;
    s.speed = 3600 * units::rpm;
    return s;
}

std::string rejection(const char* json) {
    return test::error_of([&] { read_fields<Sample>(Json::parse(json)); });
}

std::string shortest(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

TEST(Fields, WhatIsWrittenReadsBackToTheSameInput) {
    const Json json = write_fields(sample());
    EXPECT_EQ(json.dump(),
              R"({"length_mm":46.0,"depth_mm":0.1,"colour":"green","part":{"mass_g":645.0},)"
              R"("parts":[{"mass_g":100.0},{"mass_g":200.0}],"speed_rpm":3600.0})");
    EXPECT_EQ(read_fields<Sample>(json), sample());
}

TEST(Fields, RejectionsNamePlaceRuleAndFinding) {
    EXPECT_EQ(rejection(R"({"length_mm":-46,"speed_rpm":1})"),
              "/input/length_mm: must be greater than 0, got -46");
    EXPECT_EQ(rejection(R"({"length_mm":1})"),
              "/input/speed_rpm: is required and missing (or speed_rad_s)");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed":1})"),
              "/input/speed_rpm: is required and missing; found: \"speed\"");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed_rpm":1,"speed_rad_s":1})"),
              "/input/speed_rad_s: must be left out if speed_rpm is given");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed_rpm":1,"teeth":5})"),
              "/input/teeth: must be a whole number from 6 to 1000, got 5");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed_rpm":1,"colour":"blue"})"),
              "/input/colour: must be one of \"red\", \"green\", got \"blue\"");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed_rpm":1,"parts":[{"mass_g":1},{}]})"),
              "/input/parts/1/mass_g: is required and missing");
    EXPECT_EQ(rejection(R"({"length_mm":1,"speed_rpm":1,"depht_mm":1})"),
              "/input/depht_mm: is not a known key; the nearest is \"depth_mm\"");
}

TEST(Fields, TheCheckRejectsWhatTheReaderRejects) {
    Sample bad = sample();
    bad.parts[1].mass = -0.2;
    EXPECT_EQ(test::error_of([&] { check_fields(bad); }),
              "/input/parts/1/mass_g: must be at least 0, got -200");
    EXPECT_NO_THROW(check_fields(sample()));
}

TEST(Fields, EveryScalarIsReadAndSetByItsPointer) {
    Sample s = sample();
    for (const FieldEntry& entry : list_fields(s)) {
        if (entry.kind == FieldKind::number) {
            EXPECT_TRUE(set_field(s, entry.pointer, FieldValue(2.5))) << entry.pointer;
        }
    }
    EXPECT_EQ(s.length, 2.5 * units::mm);
    EXPECT_EQ(s.parts[1].mass, 2.5 * units::gram);
    EXPECT_EQ(s.speed, 2.5 * units::rpm);
    EXPECT_TRUE(set_field(s, "/depth_mm", FieldValue()));
    EXPECT_FALSE(s.depth.has_value());
    EXPECT_FALSE(set_field(s, "/length_mm", FieldValue())) << "a length cannot be empty";
    EXPECT_TRUE(set_field(s, "/share", FieldValue()));
    EXPECT_EQ(s.share, 0.5) << "what may be left out has its default when empty";
    EXPECT_FALSE(set_field(s, "/nothing", FieldValue(1.0)));
    s.part.reset();
    EXPECT_TRUE(set_field(s, "/part/mass_g", FieldValue(7.0)));
    ASSERT_TRUE(s.part.has_value());
    EXPECT_EQ(s.part->mass, 7 * units::gram);
}

struct Weight {
    std::optional<double> mass;  // kg; empty: by formula
    std::optional<Part> other;
    bool operator==(const Weight&) const = default;
};

void visit_fields(FieldVisitor& visitor, Weight& weight) {
    visitor.number_or_word(field::mass, weight.mass, "solve");
    visitor.object(field::part, weight.other,
                   [&](Part& part) { visitor.number(field::mass, part.mass); });
}

TEST(Fields, ANumberMayBeAWord) {
    const Json given = parse_json(R"({"mass_g": 46, "part": {"mass_g": 3}})");
    const Weight weight = read_fields<Weight>(given);
    EXPECT_EQ(weight.mass, 46 * units::gram);
    EXPECT_EQ(weight.other->mass, 3 * units::gram);
    EXPECT_EQ(write_fields(weight), given);
    const Json solved = parse_json(R"({"mass_g": "solve"})");
    EXPECT_EQ(read_fields<Weight>(solved), Weight());
    EXPECT_EQ(write_fields(Weight()), solved);
    EXPECT_EQ(test::error_of([] { read_fields<Weight>(parse_json(R"({"mass_g": "auto"})")); }),
              "/input/mass_g: must be a number or \"solve\", got \"auto\"");
    EXPECT_EQ(read_fields<Weight>(parse_json("{}")), Weight());
}

TEST(Fields, TheTableOfTheHelpListsEveryKey) {
    std::string keys;
    for (const FieldEntry& entry : describe_fields<Sample>()) {
        keys += entry.pointer + " ";
    }
    EXPECT_EQ(keys,
              "/length_mm /depth_mm /share /teeth /closed /name /colour /part /part/mass_g /parts "
              "/parts/0/mass_g /speed_rpm /speed_rad_s ");
}

TEST(Fields, TheTableOfTheHelpSaysWhatIsNeededAndWhatStandsIn) {
    for (const FieldEntry& entry : describe_fields<Sample>()) {
        const bool speed = entry.pointer.starts_with("/speed");
        EXPECT_EQ(entry.alternatives, speed ? std::vector<std::string>({"speed_rpm", "speed_rad_s"})
                                            : std::vector<std::string>())
            << entry.pointer;
        EXPECT_FALSE(entry.required && entry.usual != FieldValue()) << entry.pointer;
        if (entry.pointer == "/length_mm") {
            EXPECT_TRUE(entry.required);
        } else if (entry.pointer == "/share") {
            EXPECT_FALSE(entry.required);
            EXPECT_TRUE(std::holds_alternative<double>(entry.usual));
        }
    }
    for (const FieldEntry& entry : describe_fields<Weight>()) {
        EXPECT_EQ(entry.word, entry.pointer == "/mass_g" ? "solve" : "") << entry.pointer;
    }
}

// Of the doubles that read back to an SI value, the shortest text: what was typed.
TEST(Fields, AValueComesBackAsItWasTyped) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-9.0, 9.0);
    std::uniform_int_distribution<int> digits(1, 15);
    for (int i = 0; i < 20000; ++i) {
        for (const Unit& unit : {units::mm, units::gram, units::rpm, units::none}) {
            const Field field{.key = "x", .unit = unit};
            const double any = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
            const double typed = rounded_to_digits(any, digits(random));
            const double back = from_si(field, typed * unit);
            EXPECT_EQ(back * unit, typed * unit);
            EXPECT_LE(shortest(back).size(), shortest(typed).size()) << typed;
        }
    }
    const Field field{.key = "x", .unit = units::mm};
    EXPECT_EQ(from_si(field, 0.0), 0.0);
    EXPECT_TRUE(std::signbit(from_si(field, -0.0)));
    EXPECT_EQ(from_si(field, 1e300), 1e303);
}

TEST(Fields, OneIsListedAsAmongAll) {
    const auto expect_each = [](const std::vector<FieldEntry>& all, const auto& one) {
        for (const FieldEntry& entry : all) {
            const std::vector<FieldEntry> found = one(entry.pointer);
            ASSERT_EQ(found.size(), 1) << entry.pointer;
            EXPECT_EQ(found[0].pointer, entry.pointer);
            EXPECT_EQ(found[0].kind, entry.kind) << entry.pointer;
            EXPECT_EQ(found[0].value, entry.value) << entry.pointer;
            EXPECT_EQ(found[0].usual, entry.usual) << entry.pointer;
            EXPECT_EQ(found[0].required, entry.required) << entry.pointer;
            EXPECT_EQ(found[0].may_be_empty, entry.may_be_empty) << entry.pointer;
            EXPECT_EQ(found[0].word, entry.word) << entry.pointer;
            EXPECT_EQ(found[0].alternatives, entry.alternatives) << entry.pointer;
        }
        EXPECT_FALSE(all.empty());
    };
    const Sample s = sample();
    expect_each(list_fields(s), [&](const std::string& it) { return list_fields(s, it); });
    expect_each(describe_fields<Sample>(), describe_fields<Sample>);
    expect_each(describe_fields<Weight>(), describe_fields<Weight>);
    EXPECT_TRUE(list_fields(s, "/nothing").empty());
    EXPECT_TRUE(list_fields(s, "/part/nothing").empty());
    EXPECT_EQ(s, sample());
}

TEST(Fields, MessagesKeepTheirPatternAndTheirValues) {
    const Message message(Text::tr("must be from %1 to %2"), 1.5, Number{3, units::mm});
    EXPECT_EQ(message.english(), "must be from 1.5 to 3 mm");
    EXPECT_STREQ(message.pattern().english, "must be from %1 to %2");
    EXPECT_EQ(Message("plain").english(), "plain");
    EXPECT_EQ(Message(Number{2, units::gram, -2}).english(), "2.00 g");
    EXPECT_EQ(Message(Number{-0.004, units::none, -2}).english(), "0.00");
    const Message nested(Text::tr("cannot be read: %1"), message);
    EXPECT_EQ(nested.english(), "cannot be read: must be from 1.5 to 3 mm");
    EXPECT_EQ(joined("a", line_place(4)).english(), "a, line 4");
    EXPECT_EQ(joined("a & b", Text{"One p&in"}).english(), "a & b, One pin");  // a label's mnemonic
    const InputError error(table_place(4, 2), message, Number{20.5, units::degree});
    EXPECT_EQ(error.message().english(), "line 4, column 2: must be from 1.5 to 3 mm, got 20.5°");
    EXPECT_EQ(error.message().english(), error.what());
}

}  // namespace ravnoves
