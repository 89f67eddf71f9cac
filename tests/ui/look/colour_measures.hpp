#pragma once

#include <QColor>
#include <cmath>

namespace echotrail::test {

inline double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// Relative luminance, WCAG 2.
inline double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

/// Contrast ratio, WCAG 2: 1 to 21.
inline double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a) + 0.05;
    const double lb = luminance(b) + 0.05;
    return la > lb ? la / lb : lb / la;
}

struct Lab {
    double l, a, b;
};

/// CIE L*a*b*, D65.
inline Lab lab(const QColor& c) {
    const double r = linear(c.redF());
    const double g = linear(c.greenF());
    const double b = linear(c.blueF());
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Colour difference CIEDE2000 (Sharma, Wu, Dalal 2005).
inline double colourDifference(const QColor& first, const QColor& second) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double rad = pi / 180.0;
    const Lab p = lab(first);
    const Lab q = lab(second);
    const double mean_c7 = std::pow((std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2.0, 7);
    const double g = 0.5 * (1.0 - std::sqrt(mean_c7 / (mean_c7 + 6103515625.0)));
    const double ap = (1.0 + g) * p.a;
    const double aq = (1.0 + g) * q.a;
    const double cp = std::hypot(ap, p.b);
    const double cq = std::hypot(aq, q.b);
    const auto hue = [](double b, double a) {
        if (a == 0.0 && b == 0.0) return 0.0;
        const double angle = std::atan2(b, a);
        return angle < 0.0 ? angle + 2.0 * pi : angle;
    };
    const double hp = hue(p.b, ap);
    const double hq = hue(q.b, aq);
    double turn = hq - hp;
    double mean_h = (hp + hq) / 2.0;
    if (cp * cq == 0.0) {
        turn = 0.0;
        mean_h = hp + hq;
    } else if (std::abs(turn) > pi) {
        turn += turn > 0.0 ? -2.0 * pi : 2.0 * pi;
        mean_h += hp + hq < 2.0 * pi ? pi : -pi;
    }
    const double dl = q.l - p.l;
    const double dc = cq - cp;
    const double dh = 2.0 * std::sqrt(cp * cq) * std::sin(turn / 2.0);
    const double l50 = std::pow((p.l + q.l) / 2.0 - 50.0, 2);
    const double mean_c = (cp + cq) / 2.0;
    const double t = 1.0 - 0.17 * std::cos(mean_h - 30.0 * rad) + 0.24 * std::cos(2.0 * mean_h) +
                     0.32 * std::cos(3.0 * mean_h + 6.0 * rad) - 0.20 * std::cos(4.0 * mean_h - 63.0 * rad);
    const double sl = 1.0 + 0.015 * l50 / std::sqrt(20.0 + l50);
    const double sc = 1.0 + 0.045 * mean_c;
    const double sh = 1.0 + 0.015 * mean_c * t;
    const double c7 = std::pow(mean_c, 7);
    const double rotation = -2.0 * std::sqrt(c7 / (c7 + 6103515625.0)) *
                            std::sin(60.0 * rad * std::exp(-std::pow((mean_h / rad - 275.0) / 25.0, 2)));
    return std::sqrt(std::pow(dl / sl, 2) + std::pow(dc / sc, 2) + std::pow(dh / sh, 2) +
                     rotation * (dc / sc) * (dh / sh));
}

}  // namespace echotrail::test
