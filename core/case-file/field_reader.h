#pragma once

#include <deque>

#include "case-file/field_visitor.h"
#include "case-file/object_reader.h"

namespace ravnoves {

/// What a case may lack.
enum class Completeness {
    required,  ///< every value that a result needs must be there
    as_is,     ///< each value that is there is checked; what is missing stays empty, as in a form
               ///< half filled
};

/// Fills an input from the JSON of a case, and refuses with an InputError that names the JSON
/// pointer every missing key, wrong type, value out of range and unknown key.
class FieldReader final : public FieldVisitor {
  public:
    /// @param json  the object; must outlive the reader
    explicit FieldReader(const Json& json, Completeness completeness = Completeness::required,
                         std::string pointer = "/input");

    bool is_reading() const override { return true; }
    bool is_lenient() const { return completeness_ == Completeness::as_is; }
    /// Refuses what no field has asked for.
    void finish() const { readers_.back().finish(); }

    void number_or_word(const Field& field, std::optional<double>& si,
                        std::string_view word) override;
    void numbers(const Field& field, std::vector<double>& values) override;
    void integers(const Field& field, std::vector<int>& values) override;
    int one_of(std::initializer_list<std::string_view> keys, int present) override;
    bool has(std::string_view key, bool present) override;
    std::vector<std::string> names(std::vector<std::string> /*present*/) override {
        return reader().keys();
    }
    void custom(const Field& field, bool required, Custom& value) override;
    std::string pointer() const override { return readers_.back().pointer(); }
    /// The object that is read now, for what fields cannot say.
    ObjectReader& reader() { return readers_.back(); }

  protected:
    void visit_number(const Field& field, double& si, const double* fallback, bool always) override;
    void visit_optional(const Field& field, std::optional<double>& si, bool required) override;
    void visit_integer(const Field& field, int& value, const int* fallback, bool always) override;
    void visit_flag(const Field& field, bool& value, const bool* fallback, bool always) override;
    void visit_text(const Field& field, std::string& value, bool required) override;
    void visit_choice(const Field& field, int& index, const int* fallback, bool always) override;
    bool begin_object(const Field& field, bool required, bool is_there) override;
    void end_object() override;
    bool begin_list(const Field& field, std::size_t& count) override;
    void end_list() override;
    void begin_element(std::size_t index) override;
    void end_element() override;

  private:
    struct List {
        const Json* json;
        std::string pointer;
    };
    std::deque<ObjectReader> readers_;
    std::vector<List> lists_;
    Completeness completeness_;
};

/// An input read from its JSON by its visit_fields(), each value checked against its range; rules
/// that join fields are the scene's.
/// @throws InputError
template <typename Input>
Input read_fields(const Json& json, Completeness completeness = Completeness::required) {
    FieldReader reader(json, completeness);
    Input input;
    visit_fields(reader, input);
    reader.finish();
    return input;
}

}  // namespace ravnoves
