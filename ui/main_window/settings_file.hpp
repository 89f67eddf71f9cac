#pragma once

#include <QString>

namespace echotrail {

/// What was wrong with the settings' file, if anything.
struct SettingsTrouble {
    enum class Kind { None, NoAccess, SetAside, StillThere };
    Kind kind = Kind::None;
    QString path;  ///< of the file, or where the damaged one is kept now

    /// For the operator; empty where all is well.
    QString text() const;
};

/// To be called before anything reads the settings: Qt tells of a damaged file only who reads it first. They are
/// written whole beside the old ones and then renamed, so a crash leaves the old or the new; a file that is damaged all
/// the same is renamed to NAME.damaged, and the console begins with its defaults.
SettingsTrouble checkSettingsFile();

}  // namespace echotrail
