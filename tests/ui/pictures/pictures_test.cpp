#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <algorithm>

// The window in the states an operator meets, against pictures that were judged and kept beside this file. Where one
// differs, what is seen now and the difference are written to build/…/pictures. After a change that is meant:
//   ECHOTRAIL_RENEW_PICTURES=1 build/dev/bin/ui_pictures_test
// and look at each before it is committed.

namespace echotrail {
namespace {

constexpr QSize size_px(1440, 900);
/// Pictures are kept with four bits a channel: echoes are noise, and PNG packs noise badly.
constexpr int kept_step = 16;
constexpr int most_difference = 24;      ///< of a channel, 0…255: less is another build's rounding
constexpr double most_changed = 0.0001;  ///< share of pixels that may differ more

struct Shot {
    const char* state;
    const char* palette;
    const char* language;
    int ratio;
    QStringList console = {};  ///< arguments of echotrail-console; empty: a stage of ui_stage
};

QString nameOf(const Shot& shot) {
    return QString("%1-%2-%3@%4x").arg(shot.state, shot.palette, shot.language).arg(shot.ratio);
}

QImage coarse(QImage picture) {
    picture = picture.convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x) {
            const auto round = [](int level) { return level / kept_step * kept_step; };
            line[x] = qRgb(round(qRed(line[x])), round(qGreen(line[x])), round(qBlue(line[x])));
        }
    }
    return picture;
}

/// Share of pixels that differ; `difference` shows them on what was kept, darkened.
double compare(const QImage& kept, const QImage& now, QImage& difference) {
    difference = kept.convertToFormat(QImage::Format_RGB32);
    int count = 0;
    for (int y = 0; y < kept.height(); ++y)
        for (int x = 0; x < kept.width(); ++x) {
            const QRgb a = kept.pixel(x, y);
            const QRgb b = now.pixel(x, y);
            const int most =
                std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
            const bool differs = most > most_difference;
            count += differs;
            const int ground = qGray(a) / 3;
            difference.setPixel(x, y, differs ? qRgb(255, 0, 255) : qRgb(ground, ground, ground));
        }
    return static_cast<double>(count) / (static_cast<double>(kept.width()) * kept.height());
}

class Pictures : public testing::TestWithParam<Shot> {
protected:
    /// Settings and recordings of whoever runs it must not be seen.
    QImage take() {
        const Shot& shot = GetParam();
        const QString path = folder_.filePath("now.png");
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("QT_SCALE_FACTOR", QString::number(shot.ratio));
        environment.insert("LC_ALL", "C.UTF-8");
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) environment.insert(name, folder_.path());
        QProcess process;
        process.setProcessEnvironment(environment);
        const QString width = QString::number(size_px.width());
        const QString height = QString::number(size_px.height());
        if (shot.console.isEmpty())
            process.start(ECHOTRAIL_STAGE, {shot.state, shot.palette, shot.language, width, height, path});
        else
            process.start(ECHOTRAIL_CONSOLE, shot.console + QStringList{"--headless", "--palette", shot.palette,
                                                                        "--language", shot.language, "--width", width,
                                                                        "--height", height, "--screenshot-to", path});
        EXPECT_TRUE(process.waitForFinished(240'000)) << "it hangs";
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        return coarse(QImage(path));
    }
    QTemporaryDir folder_;
};

TEST_P(Pictures, AreLikeThoseThatWereKept) {
    const QString name = nameOf(GetParam());
    const QString kept_path = QString(ECHOTRAIL_PICTURES) + "/" + name + ".png";
    const QImage now = take();
    ASSERT_EQ(now.width(), size_px.width() * GetParam().ratio);
    ASSERT_EQ(now.height(), size_px.height() * GetParam().ratio);
    if (qEnvironmentVariableIsSet("ECHOTRAIL_RENEW_PICTURES")) {
        ASSERT_TRUE(now.save(kept_path, nullptr, 0)) << kept_path.toStdString();
        return;
    }
    const QImage kept(kept_path);
    ASSERT_FALSE(kept.isNull()) << kept_path.toStdString() << " is not there; see how to renew pictures";
    ASSERT_EQ(now.size(), kept.size());
    QImage difference;
    const double changed = compare(kept, now, difference);
    if (changed <= most_changed) return;
    QDir().mkpath(ECHOTRAIL_PICTURES_OUT);
    const QString out = QString(ECHOTRAIL_PICTURES_OUT) + "/" + name;
    now.save(out + "-now.png");
    difference.save(out + "-difference.png");
    ADD_FAILURE() << 100.0 * changed << " % of the picture differ: see " << out.toStdString() << "-difference.png";
}

const QStringList replay{"--demonstration", "--target", "40,-25", "--at", "60"};
const QStringList tuning =
    QStringList{"--set", "seed_excess_db=14", "--set", "gain_percent=55", "--show", "parameters"} + replay;
const QStringList start{"--show", "layers"};

INSTANTIATE_TEST_SUITE_P(
    Of, Pictures,
    testing::Values(Shot{"live", "dusk", "en", 1}, Shot{"live", "night", "zh", 2}, Shot{"lost", "dusk", "zh", 1},
                    Shot{"lost", "night", "en", 1}, Shot{"stale", "day", "en", 1}, Shot{"alerts", "night", "en", 1},
                    Shot{"alerts", "day", "zh", 1}, Shot{"replay", "day", "zh", 1, replay},
                    Shot{"replay", "dusk", "en", 2, replay}, Shot{"tuning", "dusk", "en", 1, tuning},
                    Shot{"tuning", "night", "zh", 1, tuning}, Shot{"start", "day", "en", 2, start},
                    Shot{"start", "dusk", "zh", 1, start}),
    [](const auto& test) { return nameOf(test.param).replace(QRegularExpression("[^a-z0-9]"), "_").toStdString(); });

}  // namespace
}  // namespace echotrail
