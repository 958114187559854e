namespace Godot.Collections;

public class Dictionary : System.Collections.Generic.Dictionary<string, Variant>
{
}

public class Array<T> : System.Collections.Generic.List<T>
{
}
