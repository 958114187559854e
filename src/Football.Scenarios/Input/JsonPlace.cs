using System.Text;
using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Where a reader is in a JSON text: the path of the value that it is about to read.</summary>
public sealed class JsonPlace
{
    private readonly Stack<Level> _levels = new();
    private string? _name;

    /// <summary>Whether the whole value has been read.</summary>
    public bool Ended { get; private set; }

    /// <summary>How many objects and arrays are open.</summary>
    public int Depth => _levels.Count;

    /// <summary>Goes on to the token that the reader has just read.</summary>
    /// <returns>The fault where a member is given twice.</returns>
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

    /// <summary>A fault at this place.</summary>
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
        /// <summary>Names of the members so far; null in an array.</summary>
        public HashSet<string>? Names { get; init; }

        /// <summary>The member that is being read.</summary>
        public string? Member { get; set; }

        /// <summary>The element that is being read.</summary>
        public int Index { get; set; }
    }
}
