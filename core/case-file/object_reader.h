#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/field.h"
#include "case-file/json_fwd.h"
#include "case-file/range.h"

namespace ravnoves {

/// Reads one JSON object of a case and rejects, with an InputError that names the JSON pointer,
/// every missing key, wrong type, value out of range and (in finish()) unknown key.
///
/// Every key that is asked for becomes a known key; finish() offers the nearest one for a
/// misspelt key. The reader refers to the Json it was made from, which must outlive it.
class ObjectReader {
  public:
    /// @param value    must be a JSON object, else InputError
    /// @param pointer  its JSON pointer, for example "/input"
    ObjectReader(const Json& value, std::string pointer);

    const std::string& pointer() const { return pointer_; }
    std::string pointer_to(std::string_view key) const;

    /// True where the key is there; makes it a known key.
    bool has(std::string_view key);

    double number(std::string_view key, const Range& range);
    std::optional<double> optional_number(std::string_view key, const Range& range);

    /// The field in SI units, by its key and range.
    double si(const Field& field) { return number(field.key, field.range) * field.unit; }

    std::uint64_t whole(std::string_view key, std::uint64_t min, std::uint64_t max);
    std::string text(std::string_view key);
    std::string text(std::string_view key, std::string fallback);
    /// Place of the word that is there.
    int choice(std::string_view key, std::span<const Word> words);
    /// The raw list.
    const Json& list(std::string_view key);
    /// An array of numbers, each within the range; errors name the element.
    std::vector<double> numbers(std::string_view key, const Range& range);

    /// The nested object.
    ObjectReader object(std::string_view key);
    /// The raw value of a required key, for what the calls above do not cover.
    const Json& raw(std::string_view key);
    /// Every key with a value, in the file's order, made known (objects such as {name: kg}).
    std::vector<std::string> keys();

    /// Rejects a required key that is missing while one that was not asked for is nearly it, or it
    /// without its unit.
    void reject_mistyped(std::string_view key) const;
    /// Rejects any key that was not asked for, with the nearest known key.
    void finish(const Text& unknown = Text::tr("is not a known key")) const;

  private:
    void know(std::string_view key);

    const Json& value_;
    std::string pointer_;
    std::vector<std::string> known_;
};

/// A key as a segment of a JSON pointer (RFC 6901).
std::string escape_segment(std::string_view key);

/// Whether a text is a JSON pointer to something within a document.
bool is_inner_pointer(const std::string& text);
/// The keys on the way of a JSON pointer.
/// @throws Json::exception for another text
std::vector<std::string> keys_of(const std::string& pointer);

/// A text of the user's as a message shows it: control characters as \u001b, which a terminal does
/// not obey, also those that turn the direction of letters; cut after `longest` bytes.
std::string printable(std::string_view text, std::size_t longest = 80);

/// The value as an error message shows it: compact JSON, printable(), cut after 40.
std::string show(const Json& value);

/// The candidate nearest to the word by edit distance, or nothing where none is near.
std::optional<std::string> nearest_word(std::string_view word,
                                        const std::vector<std::string>& candidates);

}  // namespace ravnoves
