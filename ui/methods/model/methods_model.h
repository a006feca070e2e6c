#pragma once

#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "methods/measure.h"
#include "methods/report.h"
#include "model/background_job.h"
#include "model/scene_model.h"

namespace ravnoves {

/// Times and errors of a kernel at one value of one of its hard parameters, and its errors along
/// that parameter.
struct MethodMeasurement {
    std::shared_ptr<const methods::StabilityMap> map;
    methods::KernelReport report;

    const methods::Kernel& kernel() const { return *report.kernel; }
    const methods::SweepInfo& sweep() const { return kernel().sweeps[report.sweep]; }
};

/// The state of the page "Methods": the kernel looked at, its hard parameter and value, and the
/// measurements. It is no case, so it has no file.
///
/// The chosen kernel is measured automatically while the page is in front; the newest measurement
/// remains until the next is complete.
class MethodsModel : public SceneModel {
    Q_OBJECT

  public:
    explicit MethodsModel(QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("methods"); }
    bool hasCaseFile() const override { return false; }
    Json inputJson() const override;
    /// @throws InputError always: no case has this page's word
    void loadFile(const CaseFile& file, const CaseContext& context, bool isNamed = false) override;
    Json resultJson() const override;
    /// "kernel", "sweep" (by id) and "value".
    /// @throws InputError for a word or a number that is not allowed there
    bool setViewOption(const QString& key, const QString& value) override;
    /// Of the newest measurement; nothing before any.
    std::optional<Verdict> verdictShown() const override {
        return shown_ != nullptr ? std::optional(methods::verdict(shown_->report)) : std::nullopt;
    }

    /// Only the page in front measures.
    void setActive(bool active);

    const std::vector<methods::Kernel>& kernels() const { return methods::kernels(); }
    std::size_t kernelIndex() const { return kernel_; }
    const methods::Kernel& kernel() const { return kernels()[kernel_]; }
    void setKernel(std::size_t kernel);
    std::size_t sweepIndex() const { return chosen().sweep; }
    const methods::SweepInfo& sweep() const { return kernel().sweeps[sweepIndex()]; }
    void setSweep(std::size_t sweep);
    /// Of the hard parameter: the preset's until it is set.
    double value() const { return chosen().value.value_or(sweep().present); }
    /// Kept within the sweep.
    void setValue(double value);

    /// The method whose failing regions are shaded; its index in kernel().methods.
    std::size_t shownMethod() const { return chosen().method; }
    void setShownMethod(std::size_t method);

    /// The measurement under way, of the chosen quantity.
    BackgroundJob* measuring() { return measuring_; }
    /// The measurement shown: the newest of the kernel or, before its first, of the previous
    /// kernel. Null before any.
    const MethodMeasurement* shown() const { return shown_.get(); }
    /// Shows one of the chosen kernel as its newest.
    void show(std::shared_ptr<const MethodMeasurement> measurement);
    /// It has another kernel, parameter or value than the chosen one, or a newer one is being
    /// measured.
    bool isStale() const;
    void measureAgain();
    void cancel();

    // Of an editing of the value.
    bool takeBack() override;
    void editingEnds() override { before_.reset(); }

  Q_SIGNALS:
    void kernelChanged();
    void sweepChanged();
    void valueChanged(double value);
    void shownMethodChanged();
    /// shown() or isStale() is another.
    void measurementChanged();
    void failed(const QString& why);

  private:
    /// The choices for a kernel; kept while another is looked at.
    struct Choice {
        std::size_t sweep = 0;
        std::optional<double> value;  ///< empty: the preset's
        std::size_t method = 0;
        std::shared_ptr<const MethodMeasurement> newest{};
        /// By sweep: the errors along it do not change.
        std::map<std::size_t, std::shared_ptr<const methods::StabilityMap>> maps{};
    };
    const Choice& chosen() const { return choices_[kernel_]; }
    Choice& chosen() { return choices_[kernel_]; }
    void choiceMoved(int delay);
    bool isOfChoice(const MethodMeasurement& measurement) const;
    void measure(const methods::MeasureOptions& options);
    void measureIfNeeded();

    std::size_t kernel_ = 0;
    std::vector<Choice> choices_;
    std::optional<double> before_;  ///< the value before the editing that continues
    bool active_ = false;
    BackgroundJob* measuring_;  ///< cancelled when another kernel or sweep is chosen
    std::shared_ptr<const MethodMeasurement> shown_;
    QTimer settle_;  ///< so that a drag is measured where it ends
};

}  // namespace ravnoves
