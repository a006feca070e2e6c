#pragma once

#include <QLabel>

namespace ravnoves {

class StudyModel;
struct StudyAnswer;

/// The share of each input in a result's variance, the largest at the top: a bar alone, and its
/// paler end with its interactions.
class TornadoView : public QLabel {
    Q_OBJECT

  public:
    explicit TornadoView(QWidget* parent = nullptr);

    /// Null: nothing.
    void setShares(const StudyAnswer* value, const StudyModel& study);
};

}  // namespace ravnoves
