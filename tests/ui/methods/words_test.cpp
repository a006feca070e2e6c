#include "methods/model/method_words.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "methods/kernel.h"
#include "methods/model/validation_model.h"
#include "text/language.h"
#include "text/number_text.h"

namespace ravnoves {
namespace {

using methods::Kernel;

/// Russian while it lives.
struct InRussian {
    InRussian() { installLanguage(QStringLiteral("ru")); }
    ~InRussian() { installLanguage(QStringLiteral("en")); }
};

/// All that core says of the kernels and that the page shows.
std::vector<Message> kernelTexts() {
    std::vector<Message> texts;
    for (const Kernel& kernel : methods::kernels()) {
        texts.insert(texts.end(), {kernel.title, kernel.quantity, kernel.error_measure,
                                   kernel.evaluation, kernel.reference, kernel.choice.reason});
        for (const auto& method : kernel.methods) {
            texts.insert(texts.end(), {method.title, method.limits});
            for (const auto& setting : method.settings) {
                texts.push_back(setting.label);
            }
        }
        for (std::size_t i = 0; i < kernel.sweeps.size(); ++i) {
            texts.emplace_back(kernel.sweeps[i].title);
            // What the methods say where they reject: at the ends, where it is hardest.
            for (const double value : {kernel.sweeps[i].from, kernel.sweeps[i].to}) {
                if (kernel.id == "hinge-motion" && kernel.sweeps[i].id == "turns") {
                    continue;  // thousands of turns reject nothing
                }
                const auto problem = kernel.problem(i, value);
                for (std::size_t m = 0; m < kernel.methods.size(); ++m) {
                    texts.push_back(methods::evaluate(problem, m, 0).rejection);
                }
            }
        }
    }
    return texts;
}

TEST(MethodWords, EnglishStaysAsItIs) {
    EXPECT_EQ(methodText({Text::tr("%1 points"), 64}), QStringLiteral("64 points"));
    EXPECT_EQ(methodText("0.1°"), QStringLiteral("0.1°"));
    EXPECT_EQ(methodText("1e-6"), QStringLiteral("10⁻⁶"));
    EXPECT_EQ(methodText({Text::tr("to %1°"), "1e-6"}), QStringLiteral("to 10⁻⁶°"));
    EXPECT_EQ(methodText("P_j1 max, 4.25"), QStringLiteral("P_j1 max, 4.25"));
    EXPECT_EQ(methodText(""), QString());
}

/// In Russian no English word is left (but for names of types and of functions).
TEST(MethodWords, RussianHasNoEnglishLeft) {
    const InRussian russian;
    static const QRegularExpression english(QStringLiteral("\\b[a-z]{3,}\\b"));
    const auto check = [&](const QString& text) {
        QString rest = text;
        for (const char* name : {"float", "double", "arcsin", "sin", "cos", "max", "ups"}) {
            rest.remove(QLatin1String(name));
        }
        EXPECT_FALSE(rest.contains(english)) << text.toStdString();
    };
    for (const Message& text : kernelTexts()) {
        check(methodText(text));
    }
    for (const methods::ValidationRow& row : methods::validate().rows) {
        check(methodText(row.place));
        check(methodText(row.quantity));
        check(methodText(row.reason));
        check(unitText(row.unit));
    }
    for (const methods::Paper& paper : methods::papers()) {
        check(methodText(paper.authors));
        check(methodText(paper.citation));
    }
    EXPECT_EQ(methodText("0.1°"), QStringLiteral("0,1°"));
    EXPECT_EQ(methodText({Text::tr("%1 steps"), 7200}), QStringLiteral("7200 шагов"));
}

TEST(MethodWords, TimesAndErrorsReadWell) {
    EXPECT_EQ(timeText(1.0), QStringLiteral("1\u00A0ns"));
    EXPECT_EQ(timeText(12.34), QStringLiteral("12.3\u00A0ns"));
    EXPECT_EQ(timeText(999.9), QStringLiteral("1\u00A0µs"));
    EXPECT_EQ(timeText(1e5), QStringLiteral("100\u00A0µs"));
    EXPECT_EQ(timeText(2.5e9), QStringLiteral("2.5\u00A0s"));
    EXPECT_EQ(timeText(0.01), QStringLiteral("0.01\u00A0ns"));
    EXPECT_EQ(errorNumber(0.0), QStringLiteral("0"));
    EXPECT_EQ(errorNumber(1e-9), QStringLiteral("10⁻⁹"));
    EXPECT_EQ(errorNumber(3.21e-16), QStringLiteral("3.2·10⁻¹⁶"));
    EXPECT_EQ(resultText({0.0, "the mechanism locks"}), QStringLiteral("rejected"));
}

TEST(MethodWords, StretchesReadWell) {
    const Message stretches =
        joined(Message(Text::tr("%1 to %2"), 0.1, 0.3), Message(Text::tr("from %1"), 0.9));
    EXPECT_EQ(methodText(stretches), QStringLiteral("0.1 to 0.3, from 0.9"));
    const InRussian russian;
    EXPECT_EQ(methodText(stretches), QStringLiteral("от 0,1 до 0,3, от 0,9"));
    EXPECT_EQ(methodText({Text::tr("up to %1"), Number{300.0, units::rad_per_s, 3}}),
              QStringLiteral("до 300\u00A0рад/с"));
}

}  // namespace
}  // namespace ravnoves
