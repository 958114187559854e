namespace Godot.Collections;

public class Dictionary : System.Collections.Generic.Dictionary<string, Variant>
{
}

public class Array<T> : System.Collections.Generic.List<T>
{
}

public class Array : System.Collections.Generic.List<Variant>
{
    public void Resize(int newSize)
    {
        while (Count < newSize)
        {
            Add(default);
        }
    }
}
