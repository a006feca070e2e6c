#pragma once

#include "v8-plugs/v8_sheet.h"

class QPushButton;

namespace ravnoves {

/// Sheet 2: the values of the engine; engines of the user's own are kept and removed here.
class EngineSheet : public V8Sheet {
    Q_OBJECT

  public:
    explicit EngineSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    void addPlugs(const QString& label, const QString& name, const QString& hint,
                  v8_plugs::EngineGroup group, bool v8_plugs::Engine::*member);
    void addValues(v8_plugs::EngineGroup group);
    void addOwnEngineButtons();
    QString presentName() const;
    QString askName(const QString& title, const QString& suggestion);
    void report(const QString& title, const QString& trouble, const QString& done);
    void saveEngine();
    void renameEngine();
    void removeEngine();

    QPushButton* rename_ = nullptr;
    QPushButton* remove_ = nullptr;
};

}  // namespace ravnoves
