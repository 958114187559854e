namespace FootballPhysics.Passes;

/// <summary>A body of the library: a method, a constructor, an operator, or an accessor of a property.</summary>
/// <param name="File">The index of its file.</param>
/// <param name="Line">The line where its declaration starts.</param>
/// <param name="Lines">The number of its working lines: code without lines that hold only brackets.</param>
/// <param name="Name">The name of the type and of the member.</param>
internal sealed record Method(int File, int Line, int Lines, string Name);
