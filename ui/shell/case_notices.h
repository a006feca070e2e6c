#pragma once

#include <QWidget>

namespace ravnoves {

class CaseDocument;
class DiskNotice;
class SolvingNotice;

/// What stands over the page of the case in front: that its file is another one, and what is done
/// about that; that it is being solved. Without anything to say it has no height.
class CaseNotices : public QWidget {
    Q_OBJECT

  public:
    explicit CaseNotices(QWidget* parent = nullptr);

    /// @param page  has the focus again where a notice that had it hides
    void showFor(CaseDocument* document, QWidget* page);

  private:
    void reload();
    void keep();

    DiskNotice* disk_;
    SolvingNotice* solving_;
    CaseDocument* document_ = nullptr;
};

}  // namespace ravnoves
