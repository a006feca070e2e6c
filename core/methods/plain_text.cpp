#include "methods/plain_text.h"

#include <algorithm>
#include <utility>

#include "numerics/demand.h"

namespace ravnoves::methods {

namespace {

constexpr std::size_t gap = 2;              // between columns
constexpr std::size_t narrowest_text = 20;  // of a wrapped column

/// Words put together to lines of at most `width` characters; a longer word has its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::vector<std::string> lines(1);
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (!lines.back().empty() && shown_width(lines.back()) + 1 + shown_width(word) > width) {
            lines.emplace_back();
        }
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        begin = end + 1;
    }
    return lines;
}

std::string spaces(std::size_t count) {
    return std::string(count, ' ');
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        line += i == 0 ? "" : ",";
        const std::string& field = fields[i];
        if (field.find_first_of(",\"\r\n") == std::string::npos) {
            line += field;
            continue;
        }
        line += '"';
        for (const char c : field) {
            line += c == '"' ? std::string("\"\"") : std::string(1, c);
        }
        line += '"';
    }
    return line + "\n";
}

std::size_t shown_width(std::string_view text) {
    std::size_t width = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool continues = (byte & 0xC0U) == 0x80U;
        // U+0300…U+036F
        const bool combines = byte == 0xCCU || (byte == 0xCDU && i + 1 < text.size() &&
                                                static_cast<unsigned char>(text[i + 1]) < 0xB0U);
        width += continues || combines ? 0 : 1;
    }
    return width;
}

std::string hanging(const std::string& mark, const std::string& text, std::size_t width) {
    const std::size_t indent = shown_width(mark);
    std::string result;
    for (const std::string& line : wrapped(text, std::max(width, indent + 1) - indent)) {
        result += (result.empty() ? mark : spaces(indent)) + line + "\n";
    }
    return result;
}

void AlignedTable::heading(std::string text) {
    lines_.push_back({std::move(text)});
}

void AlignedTable::add(std::vector<std::string> cells) {
    RAVNOVES_DEMAND(cells.size() == columns_.size(), "a line must have a cell for each column");
    lines_.push_back(std::move(cells));
}

std::string AlignedTable::text(std::size_t width) const {
    std::vector<std::size_t> widths;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        widths.push_back(shown_width(columns_[k].title));
        for (const auto& line : lines_) {
            if (line.size() == columns_.size()) {
                widths.back() = std::max(widths.back(), shown_width(line[k]));
            }
        }
    }
    std::size_t indent = 0;
    for (std::size_t k = 0; k + 1 < widths.size(); ++k) {
        indent += widths[k] + gap;
    }
    const std::size_t room =
        width >= indent + narrowest_text ? width - indent : std::max(widths.back(), narrowest_text);
    widths.back() = std::min(widths.back(), room);

    std::string text;
    const auto put = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
            const std::string pad = spaces(widths[k] - shown_width(cells[k]));
            line += columns_[k].right ? pad + cells[k] : cells[k] + pad;
            line += spaces(gap);
        }
        for (const std::string& part : wrapped(cells.back(), room)) {
            line += part;
            line.erase(line.find_last_not_of(' ') + 1);
            text += line + "\n";
            line = spaces(indent);
        }
    };
    std::vector<std::string> titles;
    std::size_t whole = indent + widths.back();
    for (const Column& column : columns_) {
        titles.push_back(column.title);
    }
    put(titles);
    for (std::size_t i = 0; i < whole; ++i) {
        text += "─";
    }
    text += "\n";
    for (const auto& line : lines_) {
        if (line.size() == columns_.size()) {
            put(line);
        } else {
            text += line.front() + "\n";
        }
    }
    return text;
}

}  // namespace ravnoves::methods
