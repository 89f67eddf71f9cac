#pragma once

#include <QFont>

namespace echotrail {

/// All lengths on the screen come from the size of the text, so that one scale moves everything.
class UiMetrics {
public:
    static constexpr double base_pixel_size = 12.0;  ///< of the normal text at scale 1

    explicit UiMetrics(const QFont& font);

    /// A length that is `at_base` px while the text is 12 px.
    double length(double at_base) const { return at_base * scale_; }
    int pixels(double at_base) const;
    double scale() const { return scale_; }

    /// The same family in another of the few sizes: 10, 11, 12, 15, 17, 20 at scale 1.
    QFont sized(const QFont& font, double at_base, bool semibold = false) const;

private:
    double scale_;
};

/// The application's text font at a scale: Noto Sans, behind it Noto Sans CJK SC for Chinese and DejaVu Sans where
/// neither is installed.
QFont applicationFont(double scale);
/// Figures of a clock, all of one width.
QFont clockFont(const QFont& font);

}  // namespace echotrail
