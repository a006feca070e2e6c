#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "text/shown_units.h"

namespace ravnoves {

/// What the window calls the places of a case: by the labels of the fields that a scene describes,
/// else by their keys as text.
class FieldNames {
  public:
    FieldNames() = default;
    /// Of two entries for one place the first counts.
    explicit FieldNames(const std::vector<std::vector<FieldEntry>>& lists);

    /// The description of a leaf, by its pointer below "input", or of the nearest object or list
    /// around it; any element of a list is described as its first.
    const FieldEntry* find(const std::string& pointer) const;
    /// The same, and a leaf without a label of its own is itself: for its unit and its words.
    const FieldEntry* described(const std::string& pointer) const;
    /// The description of a place itself; null without one.
    const FieldEntry* entryAt(const std::string& pointer) const;
    /// Its label, or the label of the field that may be given in its place, else its key as text.
    QString ownName(const std::string& pointer) const;
    /// How the form shows a number of an entry: where another field names it, in the unit of that.
    ShownUnit shown(const FieldEntry& entry) const;
    /// "Crank radius r", "Reciprocating masses, piston"; of a list's element with its place,
    /// from 1.
    QString name(const std::string& pointer) const;

    /// The place of an error: "row 4, torque" for "/input/torque/torque_Nm/3". Other texts are
    /// unchanged.
    QString place(const Message& where) const;
    /// What an error says, without keys and pointers.
    QString errorText(const InputError& error) const;

  private:
    const FieldEntry* labelled(const FieldEntry& entry) const;
    QString named(const std::string& word, const std::string& where) const;
    QStringList insideInput(const std::vector<std::string>& keys) const;

    std::map<std::string, FieldEntry> fields_;
};

/// An input that a model rejects, with the window's text.
class RejectedInput : public InputError {
  public:
    RejectedInput(const InputError& error, QString said)
        : InputError(error), said_(std::move(said)) {}

    const QString& said() const noexcept { return said_; }

  private:
    QString said_;
};

}  // namespace ravnoves
