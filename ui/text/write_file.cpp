#include "text/write_file.h"

#include "case-file/text_file.h"
#include "text/error_text.h"
#include "text/file_path.h"

namespace ravnoves {

QString writeFile(const QString& path, const std::function<std::string()>& make) {
    try {
        write_text_file(fsPath(path), make());
    } catch (const std::exception& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
    return {};
}

}  // namespace ravnoves
