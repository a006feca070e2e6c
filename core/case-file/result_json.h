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
    /// The visited values; to be called once, at the end.
    Json take();

  private:
    void leaf(const ResultField& field, const ResultValue& value) override;
    bool begin_object(const ResultField& field) override;
    bool begin_list(const ResultField& field) override;
    bool begin_element(std::size_t index) override;
    void end() override;

    std::string place(std::string_view key) const;

    /// The containers being filled: the result first, then an object or a list in it. Each is put
    /// in place once it is whole, for growing objects move their contents.
    struct Level {
        std::string key;
        Json value;
        std::string pointer;
    };
    void begin(std::string key, Json empty);

    const Wanted& wanted_;
    std::vector<Level> levels_;
};

/// The wanted part of the "result" object, by the scene's visit_results() of these arguments: an
/// input, or a solved one.
template <typename... Solved>
Json result_json(const Wanted& wanted, const Solved&... solved) {
    ResultJson json(wanted);
    visit_results(json, solved...);
    return json.take();
}

}  // namespace ravnoves
