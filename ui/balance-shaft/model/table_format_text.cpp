#include "balance-shaft/model/table_format_text.h"

#include <QCoreApplication>

#include "text/number_text.h"

namespace ravnoves {

namespace {

/// The texts of this file, so that translators find them together.
struct TableFormat {
    Q_DECLARE_TR_FUNCTIONS(TableFormat)

  public:
    static QString separator(char sign) {
        switch (sign) {
            case ';':
                return tr("separated by semicolons");
            case ',':
                return tr("separated by commas");
            case '\t':
                return tr("separated by tabs");
            default:
                return tr("separated by blanks");
        }
    }

    static QString of(const balance_shaft::TableFormat& table) {
        QStringList parts{tr("%1 rows").arg(table.rows), separator(table.separator)};
        if (table.decimal_comma) {
            parts << tr("decimal comma");
        }
        parts << (table.in_radians ? tr("angles in radians") : tr("angles in degrees"));
        if (table.has_header) {
            parts << tr("with a header");
        }
        if (!table.pressure_unit.empty()) {
            parts << tr("pressure in %1").arg(unitText(table.pressure_unit));
        }
        if (table.repeated) {
            parts << tr("360° repeated to 720°");
        }
        if (table.closed) {
            parts << tr("end joined to the start");
        }
        return parts.join(QStringLiteral(", "));
    }
};

}  // namespace

QString tableFormatText(const balance_shaft::TableFormat& table) {
    return TableFormat::of(table);
}

}  // namespace ravnoves
