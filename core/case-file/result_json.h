#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/json.h"
#include "case-file/result_visitor.h"
#include "case-file/wanted.h"

namespace ravnoves {

/// Writes a result as the "result" object of its file.
class ResultJson final : public ResultVisitor {
  public:
    /// @param wanted  must outlive this
    explicit ResultJson(const Wanted& wanted);

    bool wants(std::string_view key) const override;
    void integer(const ResultField& field, std::optional<long long> value) override;
    void flag(const ResultField& field, std::optional<bool> value) override;
    void word(const ResultField& field, std::string_view word) override;
    void text(const ResultField& field, const Message& text) override;
    void texts(const ResultField& field, const std::vector<Message>& texts) override;
    void numbers(const ResultField& field, const std::vector<double>& si) override;
    void integers(const ResultField& field, const std::vector<int>& values) override;
    void rows(const ResultField& field, const std::vector<double>& si,
              std::size_t columns) override;
    void nothing(const ResultField& field) override;

    /// What was visited; to be called once, at the end.
    Json take();

  private:
    void put_number(const ResultField& field, const std::optional<double>& si) override;
    bool begin_object(const ResultField& field) override;
    bool begin_list(const ResultField& field, std::size_t count) override;
    bool begin_element(std::size_t index) override;
    void end_object() override;
    void end_list() override;

    void put(const ResultField& field, Json value);
    std::string place(std::string_view key) const;

    /// What is being filled: the result first, then an object or a list in it. Each is put where it
    /// belongs once it is whole, for objects move what they hold while they grow.
    struct Level {
        std::string key;
        Json value;
        std::string pointer;
    };
    void begin(std::string key, Json empty);
    void end();

    const Wanted& wanted_;
    std::vector<Level> levels_;
};

/// The "result" object of a scene's input.
template <typename Input>
Json result_json(const Input& input, const Wanted& wanted = {}) {
    ResultJson json(wanted);
    visit_results(json, input);
    return json.take();
}

}  // namespace ravnoves
