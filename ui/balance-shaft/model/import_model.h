#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/table_reading.h"
#include "case-file/input_error.h"
#include "numerics/slider_crank.h"

namespace ravnoves {

namespace balance_shaft {
struct Input;
}
class BackgroundJob;

/// A file of measured values during its import: its contents, how it is read, and the user's
/// decisions. All is found off the GUI thread, again after each decision.
class ImportModel : public QObject {
    Q_OBJECT

  public:
    /// @param crank  of the engine, whose compression line shows the dead centre
    /// @param strokes  of the engine
    ImportModel(balance_shaft::Measured what, const SliderCrank<double>& crank, int strokes,
                QObject* parent = nullptr);

    /// Reads a file. changed() follows, also where it cannot be read.
    void open(const QString& path);
    const QString& path() const { return path_; }
    balance_shaft::Measured what() const { return what_; }
    BackgroundJob* job() const { return job_; }

    /// The settings: those decided, and for the others what the file proposes.
    const balance_shaft::TableReading& reading() const { return look_.proposal.reading; }
    /// The user's decisions; all else is proposed.
    const balance_shaft::TableReading& decided() const { return decided_; }
    void decide(const balance_shaft::TableReading& decided);
    /// Of the file's rows, from 0; nothing for an angle that the file does not have.
    std::optional<int> column(int which) const;
    void decideColumn(int which, std::optional<int> column);

    /// The first lines, unchanged, the header's above the others.
    const std::vector<std::vector<std::string>>& lines() const { return look_.lines; }
    int headerLines() const { return static_cast<int>(reading().layout.header_lines.value_or(0)); }
    /// At most max_columns.
    int columns() const { return look_.columns; }
    static constexpr int max_columns = 1000;  ///< that a case can name
    QString heading(int column) const;
    /// The decimal sign; nothing where the numbers leave it open.
    std::optional<bool> decimalComma() const;

    /// The cycle of the file is another engine's: whether the case is to be that is asked.
    bool asksForCycle() const;
    /// The file is read as the settings say.
    bool isReady() const;
    QString understoodText() const;  ///< how it was read; empty where it was not
    QString troubleText() const;     ///< why it was not
    QString doubtsText() const;      ///< doubts, a line each

    /// "Dead centre: shift by −1.3° ± 0.4° (from the compression line)"; empty where none is found.
    QString deadCentreText() const;
    /// The angles of the case are shifted by as much.
    bool isShifted() const;
    void setShifted(bool isShifted) { shifted_ = isShifted; }

    /// A case keeps columns, unit and gauge of a pressure file. What else must be known to read it
    /// is lost, unless its cycle becomes a file of its own.
    bool needsOwnFile() const { return look_.needsOwnFile; }
    /// Writes that file, which takes the place of the one that was read.
    /// @return empty, or what went wrong
    QString writeOwnFile(const QString& path);

    const std::optional<balance_shaft::ParsedCycle>& cycle() const { return look_.cycle; }
    /// Puts the pressure trace into an input; its cylinder becomes the present engine's.
    void putTraceInto(balance_shaft::Input& input) const;

  Q_SIGNALS:
    void changed();

  private:
    /// All that a look at the file finds.
    struct Look {
        balance_shaft::ReadingProposal proposal;
        std::vector<std::vector<std::string>> lines;
        int columns = 0;
        std::optional<InputError> trouble;
        std::optional<balance_shaft::ParsedCycle> cycle;
        std::optional<balance_shaft::DeadCentre> deadCentre;
        balance_shaft::TableReading kept;  ///< what the case says of the file
        bool needsOwnFile = false;
        std::string sum;  ///< SHA-256 of the file
    };

    /// @param continues  called between the steps, each of which reads the whole file; false ends
    ///                   the look, which is then useless
    static Look lookAt(const std::string& text, balance_shaft::Measured what,
                       const balance_shaft::TableReading& decided, const SliderCrank<double>& crank,
                       const std::function<bool(double)>& continues);
    static void chooseKept(const std::string& text, Look& look);
    void start();

    balance_shaft::Measured what_;
    SliderCrank<double> crank_;
    int strokes_;
    BackgroundJob* job_;
    QString path_;
    std::shared_ptr<const std::string> text_;  ///< null until it is read
    balance_shaft::TableReading decided_;
    Look look_;
    QString unreadable_;  ///< why there are no lines to show
    std::optional<bool> shifted_;
};

}  // namespace ravnoves
