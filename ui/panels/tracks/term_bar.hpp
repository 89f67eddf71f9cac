#pragma once

#include <QWidget>

namespace echotrail {

/// One term of a likelihood: its logarithm as a bar that grows to the left the less likely it is, and as a number. A
/// term beyond `doubtful` is a warning.
class TermBar : public QWidget {
    Q_OBJECT

public:
    static constexpr double doubtful = -2.2;  ///< one in nine of a Gaussian's own values is farther off
    static constexpr double longest = -6.0;   ///< the bar ends there

    explicit TermBar(QWidget* parent = nullptr);
    /// Not finite: unknown.
    void setTerm(double log_likelihood);
    double term() const { return term_; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double term_;
};

}  // namespace echotrail
