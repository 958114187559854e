using System.Text;
using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>The position of a reader in a JSON text: the path of the value that it reads next.</summary>
public sealed class JsonPlace
{
    private readonly Stack<Level> _levels = new();
    private string? _name;

    /// <summary>True if the root value is complete.</summary>
    public bool Ended { get; private set; }

    /// <summary>The number of open objects and arrays.</summary>
    public int Depth => _levels.Count;

    /// <summary>Advances to the token that the reader has just read.</summary>
    /// <returns>The error if a member occurs twice; otherwise null.</returns>
    public JsonFault? Enter(ref Utf8JsonReader reader)
    {
        switch (reader.TokenType)
        {
            case JsonTokenType.StartObject:
                _levels.Push(new Level { Names = [] });
                return null;
            case JsonTokenType.StartArray:
                _levels.Push(new Level());
                return null;
            case JsonTokenType.PropertyName:
                Level at = _levels.Peek();
                at.Member = reader.GetString()!;
                return at.Names!.Add(at.Member) ? null : Fault("given twice", "once");
            case JsonTokenType.EndObject or JsonTokenType.EndArray:
                _levels.Pop();
                break;
            case JsonTokenType.String:
                string text = reader.GetString()!;
                _name = _levels is { Count: 1 } && _levels.Peek().Member == "name" ? text : _name;
                break;
        }

        if (_levels.TryPeek(out Level? parent))
        {
            parent.Index++;
            parent.Member = null;
        }
        else
        {
            Ended = true;
        }

        return null;
    }

    /// <summary>Creates an error at this position.</summary>
    public JsonFault Fault(string value, string expected) => new(Path(), value, expected, _name);

    private string Path()
    {
        var path = new StringBuilder();
        foreach (Level level in _levels.Reverse())
        {
            path.Append(level.Names is null ? $"[{level.Index}]" : level.Member is null ? "" : path.Length > 0 ? "." + level.Member : level.Member);
        }

        return path.ToString();
    }

    private sealed class Level
    {
        /// <summary>The names of the members so far; null in an array.</summary>
        public HashSet<string>? Names { get; init; }

        /// <summary>The name of the current member.</summary>
        public string? Member { get; set; }

        /// <summary>The index of the current element.</summary>
        public int Index { get; set; }
    }
}
