#include "text/field_names.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <utility>

#include "text/capital.h"
#include "text/key_words.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

bool isPlace(const std::string& segment) {
    return !segment.empty() && segment.size() < 9 &&
           segment.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<std::string> segmentsOf(const std::string& pointer) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
        all.push_back(pointer.substr(at + 1, end - at - 1));
        at = end;
    }
    return all;
}

/// A segment of a pointer as the key that it stands for.
std::string unescaped(std::string segment) {
    for (const auto& [code, sign] : {std::pair("~1", "/"), std::pair("~0", "~")}) {
        for (std::size_t at = 0; (at = segment.find(code, at)) != std::string::npos; ++at) {
            segment.replace(at, 2, sign);
        }
    }
    return segment;
}

std::string lastKey(const std::string& pointer) {
    return unescaped(pointer.substr(pointer.rfind('/') + 1));
}

/// Every element of a list as its first.
std::string likeFirst(const std::string& pointer) {
    std::string like;
    for (const std::string& segment : segmentsOf(pointer)) {
        like += isPlace(segment) ? "/0" : "/" + segment;
    }
    return like;
}

QString rowText(const std::string& segment) {
    return QCoreApplication::translate("Errors", "row %1").arg(std::stoi(segment) + 1);
}

QString inQuotes(const QString& word) {
    return QLatin1Char('"') + word + QLatin1Char('"');
}

/// A key that no field has, as it was typed.
QString strangeKey(const std::string& key) {
    return inQuotes(QString::fromStdString(key).replace(QLatin1Char('_'), QLatin1Char(' ')));
}

bool isQuoted(const std::string& word) {
    return word.size() > 2 && word.front() == '"' && word.back() == '"';
}

}  // namespace

FieldNames::FieldNames(const std::vector<std::vector<FieldEntry>>& lists) {
    for (const auto& entries : lists) {
        for (const FieldEntry& entry : entries) {
            fields_.emplace(likeFirst(entry.pointer), entry);
        }
    }
}

const FieldEntry* FieldNames::find(const std::string& pointer) const {
    for (std::string at = likeFirst(pointer); !at.empty(); at.erase(at.rfind('/'))) {
        const auto found = fields_.find(at);
        if (found != fields_.end() && labelled(found->second) != nullptr) {
            return &found->second;
        }
    }
    return nullptr;
}

const FieldEntry* FieldNames::described(const std::string& pointer) const {
    const FieldEntry* own = entryAt(pointer);
    return own != nullptr ? own : find(pointer);
}

ShownUnit FieldNames::shown(const FieldEntry& entry) const {
    const auto isSpeed = [](const Unit& unit) {
        return unit.name == units::rpm.name || unit.name == units::rad_per_s.name;
    };
    const FieldEntry* named = labelled(entry);
    ShownUnit unit = shownUnit(entry.field);
    if (named != nullptr && isSpeed(named->field.unit) && isSpeed(entry.field.unit)) {
        unit = shownUnit(named->field);
        unit.factor *= entry.field.unit.to_si / named->field.unit.to_si;
    }
    return unit;
}

QString FieldNames::name(const std::string& pointer) const {
    const FieldEntry* entry = find(pointer);
    QStringList parts;
    parts << (entry != nullptr ? fieldName(labelled(*entry)->field) : keyInWords(lastKey(pointer)));
    for (const std::string& segment : segmentsOf(pointer)) {
        if (isPlace(segment)) {
            parts << QString::number(std::stoi(segment) + 1);
        }
    }
    // A name that the case itself gives, or a key inside a field without a label of its own.
    if (entry != nullptr && !isPlace(lastKey(pointer)) &&
        lastKey(pointer) != std::string(entry->field.key)) {
        parts << keyInWords(lastKey(pointer));
    }
    return capitalised(parts.join(QStringLiteral(", ")));
}

/// The field itself, or the one that may be given in its place and that the form names; null where
/// neither has a label.
const FieldEntry* FieldNames::labelled(const FieldEntry& entry) const {
    if (!entry.field.label.empty()) {
        return &entry;
    }
    const std::string parent = entry.pointer.substr(0, entry.pointer.rfind('/') + 1);
    for (const std::string& key : entry.alternatives) {
        const auto found = fields_.find(parent + key);
        if (found != fields_.end() && !found->second.field.label.empty()) {
            return &found->second;
        }
    }
    return nullptr;
}

const FieldEntry* FieldNames::entryAt(const std::string& pointer) const {
    const auto found = fields_.find(likeFirst(pointer));
    return found != fields_.end() ? &found->second : nullptr;
}

QString FieldNames::ownName(const std::string& pointer) const {
    const FieldEntry* entry = entryAt(pointer);
    const FieldEntry* named = entry != nullptr ? labelled(*entry) : nullptr;
    return named != nullptr ? fieldName(named->field) : keyInWords(lastKey(pointer));
}

/// @param keys  below "input"
QStringList FieldNames::insideInput(const std::vector<std::string>& keys) const {
    std::string pointer;
    for (const std::string& key : keys) {
        pointer += '/' + key;
    }
    const FieldEntry* own = entryAt(pointer);
    const bool isNamed = own != nullptr && !own->field.label.empty();
    QStringList parts;
    std::string at;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        at += '/' + keys[i];
        const bool isLast = i + 1 == keys.size();
        if (isPlace(keys[i])) {
            // An element of a list: its row, and what the list holds.
            const QStringList list =
                isLast && !parts.isEmpty() ? QStringList{parts.takeLast()} : QStringList();
            const FieldEntry* around = entryAt(at.substr(0, at.rfind('/')));
            if (isLast && (around == nullptr || around->kind == FieldKind::list)) {
                parts.clear();  // a column of a table: what it belongs to goes without saying
            }
            parts << rowText(keys[i]) << list;
            continue;
        }
        const bool holdsRows = !isLast && isPlace(keys[i + 1]);
        if (isLast || holdsRows || !isNamed) {
            parts << ownName(at);
        }
    }
    return parts;
}

QString FieldNames::place(const Message& where) const {
    const std::string text = where.english();
    if (!text.starts_with('/')) {
        return messageText(where);
    }
    std::vector<std::string> keys = segmentsOf(text);
    QStringList parts;
    const auto drop = [&](std::size_t count) {
        keys.erase(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(count));
    };
    if (keys.size() > 2 && keys[0] == "variants" && isPlace(keys[1])) {
        parts << QCoreApplication::translate("Errors", "variant %1").arg(std::stoi(keys[1]) + 1);
        drop(2);
    }
    if (keys.size() > 1 && (keys[0] == "input" || keys[0] == "kept")) {
        drop(1);
        parts += insideInput(keys);
    } else {
        for (std::string& key : keys) {
            key = unescaped(key);  // a study names its places by their pointers
            parts << (key.starts_with('/') ? name(key)
                      : isPlace(key)       ? rowText(key)
                                           : keyInWords(key));
        }
    }
    for (qsizetype i = 1; i < parts.size(); ++i) {
        parts[i] = inSentence(parts[i]);
    }
    return capitalised(parts.join(QStringLiteral(", ")));
}

/// A word of a message: where it is a key, its field's name; where a choice, its label.
/// @param where  of the error
QString FieldNames::named(const std::string& word, const std::string& where) const {
    const bool quoted = isQuoted(word);
    if (quoted && word.find("\", \"") != std::string::npos) {
        QStringList all;
        for (const QString& each : QString::fromStdString(word).split(QStringLiteral(", "))) {
            all << named(each.toStdString(), where);
        }
        return all.join(QStringLiteral(", "));
    }
    const std::string key = quoted ? word.substr(1, word.size() - 2) : word;
    const std::string root = "/input";
    if (where.starts_with(root)) {
        const std::string pointer = where.substr(root.size());
        if (const FieldEntry* entry = entryAt(pointer); entry != nullptr && quoted) {
            if (const QString choice = choiceText(entry->field, key); !choice.isEmpty()) {
                return inQuotes(choice);
            }
        }
        // A key beside the place or in it.
        for (const std::string& parent :
             {pointer.substr(0, pointer.rfind('/') + 1), pointer + '/'}) {
            if (!pointer.empty() && entryAt(parent + key) != nullptr) {
                const QString its = inSentence(ownName(parent + key));
                return quoted ? inQuotes(its) : its;
            }
        }
    }
    // Of what is no field, such as a key of the envelope.
    const bool isKey = key.find('_') != std::string::npos &&
                       std::all_of(key.begin(), key.end(), [](unsigned char c) {
                           return c == '_' || (c < 0x80 && std::isalnum(c) != 0);
                       });
    const bool isField = std::any_of(fields_.begin(), fields_.end(),
                                     [&](const auto& each) { return lastKey(each.first) == key; });
    if (where.starts_with('/') && (isKey || isField)) {
        return quoted ? inQuotes(keyInWords(key)) : keyInWords(key);
    }
    return QString::fromStdString(word);
}

QString FieldNames::errorText(const InputError& error) const {
    const std::string where = error.where();
    const auto word = [&](const std::string& each) { return named(each, where); };
    QString place = this->place(error.where_message());
    const Message& rule = error.allowed_message();
    QString allowed = messageText(rule, {.word = word});
    if (error.of() == InputError::Of::unknown_key) {
        place = strangeKey(lastKey(where));
    } else if (error.of() == InputError::Of::named_file) {
        // The file that the case names; what is wrong with it is behind.
        place += QLatin1Char(' ') + messageText(std::get<Message>(rule.arguments().front()));
        allowed = messageText(std::get<Message>(rule.arguments().back()), {.word = word});
    }
    QString text = place.isEmpty() ? allowed : place + QStringLiteral(": ") + allowed;
    const Message& found = error.found_message();
    if (found.empty()) {
        return text;
    }
    const std::string shown = found.english();
    const QString got = shown.starts_with('{')
                            ? QCoreApplication::translate("Errors", "a group of values")
                        : shown.starts_with('[') ? QCoreApplication::translate("Errors", "a list")
                                                 : messageText(found);
    return messageText(Message(Text::tr("%1, got %2"), text.toStdString(), got.toStdString()));
}

}  // namespace ravnoves
