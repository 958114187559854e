namespace Football.Physics;

/// <summary>A step that can be taken again with another length, to find what happens inside it.</summary>
internal interface ITrial
{
    /// <summary>Height of the centre at the end, m.</summary>
    double Height { get; }

    /// <summary>Vertical velocity at the end, m/s.</summary>
    double VerticalVelocity { get; }

    /// <summary>The drag law's jump at the end.</summary>
    DragJump EndJump { get; }

    /// <summary>Right-hand sides evaluated by this trial.</summary>
    int Evaluations { get; }

    /// <summary>Takes the step, from the same start, with another length.</summary>
    void Step(double h);

    /// <summary>Moves the end by a tiny time, with the acceleration that the step itself shows.</summary>
    void Nudge(double dt);

    /// <summary>Rates of the drag law's jump at the end; one evaluation.</summary>
    DragJump EndJumpRate();
}
