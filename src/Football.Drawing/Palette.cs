namespace FootballPhysics.Drawing;

/// <summary>The colours of all drawings. Colour-blind readers can distinguish the series too.</summary>
public static class Palette
{
    public const string Ink = "#1f2933";
    public const string Faint = "#7b8794";
    public const string Grid = "#e4e7eb";
    public const string Frame = "#9aa5b1";
    public const string Blue = "#0072b2";
    public const string Orange = "#e07b00";
    public const string Green = "#009e73";
    public const string Red = "#c8382b";
    public const string Purple = "#9b5fa8";
    public const string Grass = "#eef5ea";
    public const string Object = "#cbd2d9";

    public const string Paper = "#ffffff";

    /// <summary>Markings on the grass.</summary>
    public const string Marking = "#b5cbaa";

    /// <summary>The frame of a goal.</summary>
    public const string Posts = "#3e4c59";

    /// <summary>The replacement of each colour in dark mode.</summary>
    public static IReadOnlyList<(string Light, string Dark)> Dark { get; } =
    [
        (Paper, "#171d23"), (Ink, "#e4e7eb"), (Faint, "#a3b0bd"), (Grid, "#2b3640"), (Frame, "#5b6773"), (Blue, "#56b4e9"), (Orange, "#f2a33a"),
        (Green, "#2ec795"), (Red, "#ef6a5e"), (Purple, "#cf98dc"), (Grass, "#18281c"), (Object, "#3a4651"), (Marking, "#47664d"), (Posts, "#e6ebef"), ("#8d6e00", "#d9b44a"),
    ];

    /// <summary>Colours for series, in this order.</summary>
    public static IReadOnlyList<string> Series { get; } = [Blue, Orange, Green, Red, Purple, "#56b4e9", "#8d6e00"];
}
