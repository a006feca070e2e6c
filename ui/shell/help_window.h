#pragma once

#include <QDialog>

namespace ravnoves {

/// A page of the in-program help: Markdown from resources/help, in the present language where there
/// is one (TOPIC.LANG.md), else English (TOPIC.md).
class HelpWindow : public QDialog {
    Q_OBJECT

  public:
    explicit HelpWindow(const QString& topic, QWidget* parent = nullptr);
};

}  // namespace ravnoves
