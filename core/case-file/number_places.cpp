#include "case-file/number_places.h"

#include "case-file/field_walker.h"

namespace ravnoves {

namespace {

class NumberFinder final : public FieldWalker {
  public:
    explicit NumberFinder(std::span<const std::string> pointers)
        : FieldWalker(""), pointers_(pointers), places_(pointers.size()) {}

    std::vector<NumberPlace> take() { return std::move(places_); }

    void numbers(const Field& field, std::vector<double>& values) override {
        const std::string list = pointer_to(field.key) + "/";
        for (std::size_t k = 0; k < pointers_.size(); ++k) {
            if (!pointers_[k].starts_with(list)) {
                continue;
            }
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (pointers_[k].substr(list.size()) == std::to_string(i)) {
                    places_[k] = {&values[i], units::none, field.range, field.size};
                }
            }
        }
    }

  protected:
    void visit_number(const Field& field, double& si, const double* /*fallback*/,
                      bool /*always*/) override {
        offer(field, si);
    }
    void visit_optional(const Field& field, std::optional<double>& si, bool /*required*/) override {
        if (si) {
            offer(field, *si);
        }
    }

  private:
    void offer(const Field& field, double& si) {
        const std::string here = pointer_to(field.key);
        for (std::size_t k = 0; k < pointers_.size(); ++k) {
            if (pointers_[k] == here) {
                places_[k] = {&si, field.unit, field.range, field.size};
            }
        }
    }

    std::span<const std::string> pointers_;
    std::vector<NumberPlace> places_;
};

}  // namespace

std::vector<NumberPlace> detail::places_with(VisitNumbers visit, void* input,
                                             std::span<const std::string> pointers) {
    NumberFinder finder(pointers);
    visit(finder, input);
    return finder.take();
}

}  // namespace ravnoves
