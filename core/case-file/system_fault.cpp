#include "case-file/system_fault.h"

#include <cerrno>
#include <cstring>

namespace ravnoves {

Message system_fault(int error) {
    struct Fault {
        int error;
        Text text;
    };
    static constexpr Fault faults[] = {
        {ENOENT, Text::tr("No such file or directory")},
        {EACCES, Text::tr("Permission denied")},
        {EPERM, Text::tr("Operation not permitted")},
        {ENOSPC, Text::tr("No space left on device")},
        {EDQUOT, Text::tr("Disk quota exceeded")},
        {EROFS, Text::tr("Read-only file system")},
        {EISDIR, Text::tr("Is a directory")},
        {ENOTDIR, Text::tr("Not a directory")},
        {ENAMETOOLONG, Text::tr("File name too long")},
        {EFBIG, Text::tr("File too large")},
        {EBUSY, Text::tr("Device or resource busy")},
        {ELOOP, Text::tr("Too many levels of symbolic links")},
        {EMFILE, Text::tr("Too many open files")},
        {EIO, Text::tr("Input/output error")},
    };
    for (const Fault& fault : faults) {
        if (fault.error == error) {
            return fault.text;
        }
    }
    return std::strerror(error);
}

}  // namespace ravnoves
