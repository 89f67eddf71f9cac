#include "ui/main_window/settings_file.hpp"

#include "ui/main_window/main_window.hpp"

#include <QFile>
#include <QSettings>

namespace echotrail {

SettingsTrouble checkSettingsFile() {
    QString path;
    QSettings::Status status = QSettings::NoError;
    {
        const QSettings settings;
        path = settings.fileName();
        static_cast<void>(settings.allKeys());  // sections are parsed when they are asked for
        status = settings.status();
    }
    if (status == QSettings::NoError) return {};
    if (status == QSettings::AccessError) return {SettingsTrouble::Kind::NoAccess, path};
    const QString aside = path + ".damaged";
    QFile::remove(aside);  // that of an earlier time
    if (!QFile::rename(path, aside)) return {SettingsTrouble::Kind::StillThere, path};
    return {SettingsTrouble::Kind::SetAside, aside};
}

QString SettingsTrouble::text() const {
    switch (kind) {
        case Kind::None:
            break;
        case Kind::NoAccess:
            return MainWindow::tr("The settings in %1 cannot be read or written: this session is not remembered.")
                .arg(path);
        case Kind::SetAside:
            return MainWindow::tr(
                       "The settings were damaged: they are kept as %1, and the console begins with its defaults.")
                .arg(path);
        case Kind::StillThere:
            return MainWindow::tr("The settings in %1 are damaged and cannot be set aside: delete that file.")
                .arg(path);
    }
    return {};
}

}  // namespace echotrail
