// Programs are built and browsers run in folders that two tests at once would share.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
[assembly: AssemblyFixture(typeof(FootballPhysics.Web.Tests.Browser))]
