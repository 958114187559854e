using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Replay;

/// <summary>Creates the animations of an SVG. All animations of a drawing have the same period and repeat.</summary>
internal static class SvgAnimation
{
    /// <summary>Returns an animation whose attribute jumps from value to value.</summary>
    /// <param name="attribute">The attribute.</param>
    /// <param name="total">The period, in s.</param>
    /// <param name="times">The times of the values, in s.</param>
    /// <param name="values">The values.</param>
    public static XElement Steps(string attribute, double total, IEnumerable<double> times, IEnumerable<string> values) => Svg.Element(
        "animate",
        [
            ("attributeName", attribute), ("dur", Seconds(total)), ("repeatCount", "indefinite"), ("calcMode", "discrete"), ("keyTimes", Times(times.Select(time => time / total))),
            ("values", string.Join(';', values)),
        ]);

    /// <summary>Returns an animation whose attribute changes linearly between values.</summary>
    /// <param name="attribute">The attribute.</param>
    /// <param name="total">The period, in s.</param>
    /// <param name="times">The result of <see cref="Times"/>.</param>
    /// <param name="values">The values, separated by semicolons.</param>
    public static XElement Change(string attribute, double total, string times, string values) => Svg.Element(
        "animate",
        [("attributeName", attribute), ("dur", Seconds(total)), ("repeatCount", "indefinite"), ("keyTimes", times), ("values", values)]);

    /// <summary>Returns an animation of a transform.</summary>
    /// <param name="type">The type of the transform, like "translate".</param>
    /// <param name="total">The period, in s.</param>
    /// <param name="times">The result of <see cref="Times"/>.</param>
    /// <param name="values">The values, separated by semicolons.</param>
    public static XElement Transform(string type, double total, string times, string values) => Svg.Element(
        "animateTransform",
        [("attributeName", "transform"), ("type", type), ("dur", Seconds(total)), ("repeatCount", "indefinite"), ("keyTimes", times), ("values", values)]);

    /// <summary>Returns shares of the period as a text.</summary>
    public static string Times(IEnumerable<double> shares) => string.Join(';', shares.Select(share => share.ToString("0.####", CultureInfo.InvariantCulture)));

    private static string Seconds(double total) => FormattableString.Invariant($"{total:0.##}s");
}
