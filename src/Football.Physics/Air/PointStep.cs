namespace Football.Physics;

/// <summary>All that laws asked point by point keep for a step: the branch of the drag law that it is locked to.</summary>
internal struct PointStep
{
    public DragBranch Branch;
}
