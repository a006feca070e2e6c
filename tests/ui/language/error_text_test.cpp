// core's messages in Russian: every bad case that the examples can be turned into.

#include "text/error_text.h"
#include "case-file/field_index.h"

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QString>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "balance-shaft/table_reading.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/range.h"
#include "case-file/text_file.h"
#include "examples.h"
#include "language/catalogue.h"
#include "scene_tests.h"
#include "scenes/scenes.h"
#include "text/field_names.h"
#include "text/language.h"
#include "text/message_text.h"
#include "workshop/older_formats.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class ErrorText : public ::testing::Test {
  protected:
    ErrorText() { installLanguage(u"ru"_s); }
    ~ErrorText() override { installLanguage(u"en"_s); }
};

/// Words outside quotation marks that are no keys of a case file and no formula.
std::string englishIn(QString text) {
    static const QRegularExpression quoted(u"\"[^\"]*\"?"_s);
    static const QRegularExpression keys(
        u"(/[a-z0-9_~/-]+|\\w*_\\w+|\\b(csv|pressure|cycle|JSON|"
        u"null|true|false|engine|masses|layout)\\b)"_s);
    static const QRegularExpression words(u"\\b[A-Za-z]{3,}\\b"_s);
    return words.match(text.remove(quoted).remove(keys)).captured().toStdString();
}

bool isTranslated(const Text& pattern) {
    static const std::set<QString> known = [] {
        std::set<QString> texts;
        for (const test::CatalogueEntry& entry : test::readCatalogue(test::russianFile())) {
            if (entry.finished && entry.context == QLatin1String(core_texts)) {
                texts.insert(entry.source);
            }
        }
        return texts;
    }();
    return known.contains(QString::fromUtf8(pattern.english));
}

/// Every sentence in it is a pattern with a translation; what is verbatim is a key, a name or
/// quoted, and so is what a pattern that has none holds beside its places.
void expectTranslatable(const Message& message) {
    const Text& pattern = message.pattern();
    if (pattern.empty()) {
        EXPECT_EQ(englishIn(QString::fromStdString(message.verbatim())), "") << message.verbatim();
    } else if (!isTranslated(pattern)) {
        EXPECT_EQ(englishIn(QString::fromUtf8(pattern.english)), "") << pattern.english;
    }
    for (const Argument& argument : message.arguments()) {
        if (const auto* inner = std::get_if<Message>(&argument)) {
            expectTranslatable(*inner);
        }
    }
}

/// Every place of a case: pointers to all its values.
void collect(const Json& value, const Json::json_pointer& at,
             std::vector<Json::json_pointer>& places) {
    places.push_back(at);
    if (value.is_object()) {
        for (const auto& item : value.items()) {
            collect(item.value(), at / item.key(), places);
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < std::min<std::size_t>(value.size(), 2); ++i) {
            collect(value[i], at / i, places);
        }
    }
}

/// The fields of a scene.
const FieldNames& namesOf(const std::string& scene) {
    static std::map<std::string, FieldNames> all;
    const auto [place, isNew] = all.try_emplace(scene);
    if (isNew && scene == "v8-plugs") {
        place->second = FieldNames({describe_fields<workshop::PlugsCase>()});
    } else if (isNew && scene == "bob-weights") {
        place->second = FieldNames({describe_fields<workshop::BobWeightsCase>()});
    } else if (const auto page = isNew ? test::makePage(scene) : nullptr) {
        place->second = FieldNames({page->model()->describedFields()});
    }
    return place->second;
}

/// No pointer, no key with its unit, no JSON.
void expectWords(const QString& said) {
    static const QRegularExpression code(u"/input|/kept|[a-zA-Z0-9]_[a-zA-Z0-9]|[{}\\[\\]]"_s);
    EXPECT_FALSE(said.contains(code)) << said.toStdString();
}

struct Rejections {
    int count = 0;
    std::vector<std::pair<std::string, InputError>> all{};

    void tryCase(const Json& document) {
        try {
            solve_case(read_case(document), {RAVNOVES_EXAMPLES});
        } catch (const InputError& error) {
            ++count;
            EXPECT_FALSE(error.allowed_message().pattern().empty()) << error.what();
            SCOPED_TRACE(error.what());
            expectTranslatable(error.message());
            const Json scene = document.is_object() ? document.value("scene", Json()) : Json();
            all.emplace_back(scene.is_string() ? scene.get<std::string>() : std::string(), error);
            EXPECT_EQ(englishIn(namesOf(all.back().first).errorText(error)), "");
        }
    }
    void expectInWords() const {
        for (const auto& [scene, error] : all) {
            SCOPED_TRACE(error.what());
            const QString said = namesOf(scene).errorText(error);
            expectWords(said);
            expectWords(errorText(error));
        }
    }
};

TEST_F(ErrorText, OfEveryBadCaseIsRussian) {
    Rejections rejections;
    for (const auto& file : test::example_files()) {
        const Json good = parse_json(read_text_file(file));
        if (good.at("scene") == "workshop") {
            continue;  // it has no page: the command line speaks English
        }
        std::vector<Json::json_pointer> places;
        collect(good, Json::json_pointer(), places);
        for (const Json::json_pointer& place : places) {
            for (const Json& wrong :
                 {Json("word"), Json(-1.5), Json(1e90), Json::array(), Json{{"strange", 1}}}) {
                Json bad = good;
                bad[place] = wrong;
                rejections.tryCase(bad);
            }
            if (!place.empty() && good[place.parent_pointer()].is_object()) {
                Json bad = good;
                bad[place.parent_pointer()].erase(place.back());
                rejections.tryCase(bad);
                bad[place.parent_pointer()][place.back() + "x"] = 1;
                rejections.tryCase(bad);
            }
        }
    }
    EXPECT_GT(rejections.count, 500);
    rejections.expectInWords();
    installLanguage(u"en"_s);
    rejections.expectInWords();
}

TEST_F(ErrorText, OfABadTableIsRussian) {
    for (const char* text :
         {"", "0;1\n1;2", "0;1;2\n", "0\n1\n2\n", "0;a\n1;2\n2;3\n", "0;1\n0;2\n720;1\n",
          "0;1\n400;2\n300;3\n720;1\n", "0;1\n360;2\n720;9\n", "0;1\n100;2\n300;1\n",
          "0,5,1,5\n1,5,2,5\n", "1\x01\n", "200000;1\n0;1\n1;1\n"}) {
        try {
            balance_shaft::parse_cycle(balance_shaft::Measured::torque, text);
            ADD_FAILURE() << "taken: " << text;
        } catch (const InputError& error) {
            SCOPED_TRACE(error.what());
            expectTranslatable(error.message());
            EXPECT_EQ(englishIn(errorText(error)), "");
        }
    }
}

const Text finite = Text::tr("must be a finite number");

TEST_F(ErrorText, KeepsPlaceAndValues) {
    EXPECT_EQ(errorText(InputError("/input/crank_radius_mm", Range::greater_than(0.0).message(),
                                   Number{-46.5}))
                  .toStdString(),
              "Crank radius: должно быть больше 0, получено −46,5");
    EXPECT_EQ(namesOf("balance-shaft")
                  .errorText(InputError("/input/crank_radius_mm",
                                        Range::greater_than(0.0).message(), Number{-46.5}))
                  .toStdString(),
              "Радиус кривошипа r: должно быть больше 0, получено −46,5");
    EXPECT_EQ(errorText(InputError(table_place(4, 2), finite, "\"x.5\"")).toStdString(),
              "строка 4, столбец 2: должно быть конечным числом, получено \"x.5\"");
    try {
        write_text_file("/dev/full", "text");
        ADD_FAILURE() << "written";
    } catch (const InputError& error) {
        EXPECT_TRUE(errorText(error).startsWith(u"не удалось записать: "_s)) << error.what();
    }
    EXPECT_EQ(errorText(std::runtime_error("some.fault")).toStdString(), "some.fault");
}

TEST(ErrorTextInEnglish, IsWhatCoreSays) {
    for (const InputError& error :
         {InputError(table_place(4, 2), finite, "\"x.5\""), InputError(line_place(4), finite),
          InputError("", finite, Number{1.5, units::degree}),
          InputError("", "words of no language: 1.5", Number{1e14})}) {
        EXPECT_EQ(errorText(error).toStdString(), error.what());
    }
}

TEST(ErrorTextInEnglish, SaysPlacesInWords) {
    const FieldNames& names = namesOf("balance-shaft");
    const Text missing = Text::tr("is required and missing");
    const auto said = [&](const InputError& error) { return names.errorText(error).toStdString(); };
    EXPECT_EQ(said(InputError("/input/torque/torque_Nm/3", missing)),
              "Row 4, torque: is required and missing");
    EXPECT_EQ(said(InputError("/variants/1/input/crank_radius_mm", missing)),
              "Variant 2, crank radius r: is required and missing");
    EXPECT_EQ(
        said(InputError("/input/reciprocating_masses_kg",
                        {Text::tr("is required and missing (or %1)"), "reciprocating_mass_kg"})),
        "Reciprocating masses: is required and missing (or reciprocating mass)");
    EXPECT_EQ(
        said(InputError::in_file("/input/torque/csv", "my_trace_mm.csv", InputError({}, missing))),
        "Torque, file my_trace_mm.csv: is required and missing");
    EXPECT_EQ(said(InputError::unknown_key("/input/crank_radus_mm",
                                           {Text::tr("is not a known key; the nearest is %1"),
                                            quoted_list({"crank_radius_mm"})})),
              "\"crank radus mm\": is not a known key; the nearest is \"crank radius r\"");
    EXPECT_EQ(said(InputError("/version", missing, "{\"a_mm\":1}")),
              "Version: is required and missing, got a group of values");
    EXPECT_EQ(said(InputError("", finite, Number{1.2e200})),
              "must be a finite number, got 1.2·10²⁰⁰");
}

}  // namespace
}  // namespace ravnoves
